// The environment map: the lights seen from the object's centre. Needs tangent_frame and attenuation.
layout(binding = 0) uniform samplerCube environment_map;

// Texels hold radiance divided by this; methods multiply their sum by it.
uniform float environment_unit;

// G L_e for the light that a microfacet with normal H sends to the eye. H may have any length and n_h may
// have the same factor: 2 (V.H) H - (H.H) V is L times H.H, and neither the map's texel nor G depends on
// that.
vec3 microfacet_radiance(Surface s, float n_v, vec3 H, float n_h)
{
    float h_h = dot(H, H);
    float v_h = dot(s.V, H);
    float n_l = 2.0 * v_h * n_h - h_h * n_v;
    float g = attenuation(n_h, h_h * n_v, n_l, h_h * v_h);
    return g * texture(environment_map, 2.0 * v_h * H - h_h * s.V).rgb;
}
