// Cook and Torrance's highlight, for an irradiance of 1 perpendicular to L:
//
//     F(beta) D(delta) G / (4 N.V),   N.L > 0 and N.V > 0,   H = (L + V)/|L + V|
//
// with fresnel, and D = facets of one of the distributions' modules. params: n and m; k; n^2 - 1.

vec3 reflect_cook_torrance(Surface s, vec3 L, vec4 params[3])
{
    float n_l = dot(s.N, L);
    float n_v = dot(s.N, s.V);
    if (!(n_l > 0.0) || !(n_v > 0.0))
        return vec3(0.0);
    Half h = half_vector(L, s.V);
    if (!(h.cosine > 0.0))
        return vec3(0.0);
    vec3 across = cross(s.N, h.H);
    // A sum of what is positive: N.H of a rounded H may be below 0 at grazing incidence.
    float n_h = min(1.0, 0.5 * (n_l + n_v) / h.cosine);
    float d = facets(n_h, dot(across, across), params[0].w);
    float g = min(0.25 / n_v, 0.5 * (n_h / h.cosine) * min(1.0, n_l / n_v));
    // At a grazing angle of 1e-35 it is past the largest number; an infinity times an F of 0 is none at all.
    float factor = min(d * g, 3.4e38);
    vec3 apart = s.V - L;
    return factor * fresnel(params[0].rgb, params[1].rgb, params[2].rgb, h.cosine, 0.25 * dot(apart, apart));
}
