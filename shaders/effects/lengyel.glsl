// Fur after Lengyel, fibres along N, for an irradiance of 1 perpendicular to L:
//
//     k_d |N x L| + k_s |N x h|^p,   h = (L + V)/2
//
// params: k_d and p; k_s.

vec3 reflect_lengyel(Surface s, vec3 L, vec4 params[2])
{
    vec3 h = 0.5 * (L + s.V);
    vec3 across = cross(s.N, h);
    vec3 apart = L - s.V;
    float n_h = dot(s.N, h);
    // 1 - |N x h|^2, for |h|^2 = 1 - |L - V|^2/4.
    float rest = n_h * n_h + 0.25 * dot(apart, apart);
    float square = dot(across, across);
    float lobe = power(square, rest, 0.5 * params[0].w);
    return params[0].rgb * fur_sine(s.N, L) + params[1].rgb * lobe;
}
