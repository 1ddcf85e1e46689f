// Cook and Torrance's highlight, for an irradiance of 1 perpendicular to L:
//
//     F(beta) D(delta) G / (4 N.V),   N.L > 0 and N.V > 0,   H = (L + V)/|L + V|
//
// with fresnel, and D = facets of one of the distributions' modules. params: n and m; k.

vec3 reflect_cook_torrance(Surface s, vec3 L, vec4 params[2])
{
    vec3 sum = L + s.V;
    float length_sum = length(sum);
    float n_l = dot(s.N, L);
    float n_v = dot(s.N, s.V);
    if (!(n_l > 0.0) || !(n_v > 0.0) || !(length_sum > 0.0))
        return vec3(0.0);
    vec3 H = sum / length_sum;
    vec3 across = cross(s.N, H);
    float n_h = min(1.0, (n_l + n_v) / length_sum);
    float v_h = min(1.0, 0.5 * length_sum);
    float d = facets(n_h, dot(across, across), params[0].w);
    float g = min(0.25 / n_v, 0.5 * (n_h / v_h) * min(1.0, n_l / n_v));
    return fresnel(params[0].rgb, params[1].rgb, v_h) * (d * g);
}
