// Fur after Lengyel, fibres along N, for an irradiance of 1 perpendicular to L:
//
//     k_d |N x L| + k_s |N x h|^p,   h = (L + V)/2
//
// params: k_d and p; k_s.

vec3 reflect_lengyel(Surface s, vec3 L, vec4 params[2])
{
    float lobe = fur_power(fur_sine(s.N, 0.5 * (L + s.V)), params[0].w);
    return params[0].rgb * fur_sine(s.N, L) + params[1].rgb * lobe;
}
