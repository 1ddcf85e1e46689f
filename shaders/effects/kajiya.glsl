// Fur after Kajiya and Kay, fibres along N, for an irradiance of 1 perpendicular to L:
//
//     k_d |N x L| + k_s fur_cone(N, L, V, p)
//
// params: k_d and p; k_s.

vec3 reflect_kajiya(Surface s, vec3 L, vec4 params[2])
{
    float lobe = fur_cone(s.N, L, s.V, params[0].w);
    return params[0].rgb * fur_sine(s.N, L) + params[1].rgb * lobe;
}
