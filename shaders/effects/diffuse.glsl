// Lambert's diffuse reflection of light from direction L, for an irradiance of 1 perpendicular to it:
//
//     (k_d / pi) max(0, N.L)
//
// params: k_d / pi.

vec3 reflect_diffuse(Surface s, vec3 L, vec4 params[1])
{
    return params[0].rgb * max(0.0, dot(s.N, L));
}
