// Fresnel's reflectance of unpolarised light at a medium of complex index n - i k, per channel; c: cosine of the angle of incidence.
// The equations are in src/model/fresnel.h.
vec3 fresnel(vec3 n, vec3 k, float c)
{
    float ss = (1.0 - c) * (1.0 + c);
    // n^2 - s^2 by what cancels less.
    vec3 x = mix(n * n - ss, (n - 1.0) * (n + 1.0) + c * c, greaterThan(n, vec3(0.7))) - k * k;
    vec3 nk = n * k;
    vec3 m = sqrt(x * x + 4.0 * nk * nk);
    vec3 larger = 0.5 * (m + abs(x));
    vec3 smaller = nk * nk / max(larger, 1e-30);
    bvec3 positive = greaterThanEqual(x, vec3(0.0));
    vec3 a = sqrt(mix(smaller, larger, positive));
    vec3 bb = mix(larger, smaller, positive);
    vec3 r_s = ((a - c) * (a - c) + bb) / max((a + c) * (a + c) + bb, 1e-30);
    vec3 ac = a * c;
    vec3 p = ((ac - ss) * (ac - ss) + bb * c * c) / max((ac + ss) * (ac + ss) + bb * c * c, 1e-30);
    return 0.5 * r_s * (1.0 + p);
}
