// The half vector of light and eye, H = (L + V)/|L + V|, and the cosine |L + V|/2 of the angle between it and either; 0 where they are opposite,
// and H nothing. L + V is without its part along V - L, which is what lengths are off by 1 (src/model/half.h).
struct Half {
    vec3 H;
    float cosine;
};

Half half_vector(vec3 L, vec3 V)
{
    vec3 sum = L + V;
    vec3 apart = V - L;
    // 2^60: lengths to 1e-37, whose squares are none.
    vec3 wide = 1.152921504606846976e18 * (sum - 0.25 * dot(sum, apart) * apart);
    float size = length(wide);
    return Half(wide * (1.0 / size), min(4.33680869e-19 * size, 1.0));
}
