// Fresnel's reflectance of unpolarised light at a medium of complex index n - i k, per channel, with n_n_1 = n^2 - 1; c: cosine of the angle
// of incidence, ss: its sine squared. The equations are in src/model/fresnel.h.
vec3 fresnel(vec3 n, vec3 k, vec3 n_n_1, float c, float ss)
{
    vec3 kk = k * k;
    // n^2 - s^2 by what cancels less.
    vec3 x = mix(n * n - ss, n_n_1 + c * c, greaterThan(n, vec3(0.7))) - kk;
    vec3 nk = n * k;
    // Squares of small n - 1, c and k are no numbers any more.
    vec3 most = max(abs(x), 2.0 * nk);
    vec3 ratio = min(abs(x), 2.0 * nk) / max(most, 1e-37);
    vec3 larger = 0.5 * (most * sqrt(1.0 + ratio * ratio) + abs(x));
    vec3 smaller = nk * (nk / max(larger, 1e-37));
    bvec3 positive = greaterThanEqual(x, vec3(0.0));
    vec3 a = sqrt(mix(smaller, larger, positive));
    vec3 bb = mix(larger, smaller, positive);
    // a^2 - c^2 = n^2 - 1 - k^2 + b^2: near n = 1 a - c cancels.
    bvec3 close = lessThan(max(a, c) - 2.0 * min(a, vec3(c)), vec3(0.0));
    vec3 fused = (n_n_1 - kk + bb) / max(a + c, 1e-37);
    vec3 a_c = mix(a - c, fused, bvec3(ivec3(close) * ivec3(positive)));
    vec3 r_s = (a_c * a_c + bb) / max((a + c) * (a + c) + bb, 1e-37);
    vec3 ac = a * c;
    vec3 p = ((ac - ss) * (ac - ss) + bb * c * c) / max((ac + ss) * (ac + ss) + bb * c * c, 1e-37);
    return 0.5 * r_s * (1.0 + p);
}
