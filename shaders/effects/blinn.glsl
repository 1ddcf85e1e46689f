// Blinn's highlight: a lobe about the half vector H = (L + V)/|L + V|, for an irradiance of 1 perpendicular to L.
//
//     W(beta) (N.H)^n,   N.L > 0 and N.V > 0,   W(beta) = reflectance(k_s, g, |L + V|/2)
//
// params: k_s and n; g.

vec3 reflect_blinn(Surface s, vec3 L, vec4 params[2])
{
    float n_l = dot(s.N, L);
    float n_v = dot(s.N, s.V);
    if (!(n_l > 0.0) || !(n_v > 0.0))
        return vec3(0.0);
    Half h = half_vector(L, s.V);
    if (!(h.cosine > 0.0))
        return vec3(0.0);
    return power_of_cosine(s.N, h.H, params[0].w) * reflectance(params[0].rgb, params[1].x, h.cosine);
}
