// Lambert's diffuse reflection of each light shrunk to its centroid:
//
//     (k_d / pi) sum over lights of  radiance A |cos(light)| max(0, N.L) / r^2
//
// params: k_d / pi.
uniform vec4 diffuse_params[1];

vec3 effect_diffuse(Surface s)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < N_LIGHTS; i++) {
        PointLight light = point_lights[i];
        vec3 d = light.position.xyz - s.P;
        float r_r = dot(d, d);
        float n_d = dot(s.N, d);
        bool flat_light = dot(light.normal.xyz, light.normal.xyz) > 0.0;
        float facing = flat_light ? abs(dot(light.normal.xyz, d)) : sqrt(r_r);
        float factor = n_d > 0.0 ? light.position.w * n_d * facing / (r_r * r_r) : 0.0;
        sum += factor * light.radiance.rgb;
    }
    return diffuse_params[0].rgb * sum;
}
