// Blinn's highlight: a lobe about the half vector H = (L + V)/|L + V|, for an irradiance of 1 perpendicular to L.
//
//     W(beta) (N.H)^n,   N.L > 0 and N.V > 0,   W(beta) = reflectance(k_s, g, |L + V|/2)
//
// params: k_s and n; g.

vec3 reflect_blinn(Surface s, vec3 L, vec4 params[2])
{
    vec3 sum = L + s.V;
    float n_l = dot(s.N, L);
    float n_v = dot(s.N, s.V);
    float length_sum = length(sum);
    if (!(n_l > 0.0) || !(n_v > 0.0) || !(length_sum > 0.0))
        return vec3(0.0);
    float lobe = pow(min((n_l + n_v) / length_sum, 1.0), params[0].w);
    return lobe * reflectance(params[0].rgb, params[1].x, 0.5 * length_sum);
}
