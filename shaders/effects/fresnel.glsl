// Fresnel's reflectance at the angle between N and V, a factor on the highlight of shaped lights.
//
// params: n; k.

vec3 factor_fresnel(Surface s, vec4 params[2])
{
    return fresnel(params[0].rgb, params[1].rgb, clamp(dot(s.N, s.V), 0.0, 1.0));
}
