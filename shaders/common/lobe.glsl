// Powers of cosines, the lobes of highlights (src/model/lobe.h): x^n, by x and by how much less than 1 it is, which a rounded x near 1 does not
// know. Of unit vectors a and b, 1 - a.b = |a - b|^2/2, where their lengths count in second order only.
//
// GLSL's own pow is off by 1e-4 and more near 1 in some implementations, for their logarithm is. Here with x = m 2^k, m from sqrt(1/2) to
// sqrt(2), and f = m - 1, which is -less where k is 0: log2(x) = k + (2/ln 2) atanh(f/(2 + f)), three terms, fitted; relative error 1.2e-7.
float power(float x, float less, float n)
{
    // Below 1e-20 as there: 0 has no logarithm.
    int bits = floatBitsToInt(max(x, 1e-20));
    int k = (bits - 0x3f3504f3) >> 23;
    float f = k == 0 ? -less : intBitsToFloat(bits - (k << 23)) - 1.0;
    float s = f / (2.0 + f);
    float z = s * s;
    return exp2(n * (float(k) + s * (2.88539042 + z * (0.961588912 + z * 0.595761199))));
}

// max(0, a.b)^n of unit vectors.
float power_of_cosine(vec3 a, vec3 b, float n)
{
    vec3 apart = a - b;
    float less = 0.5 * dot(apart, apart);
    return less < 1.0 ? power(1.0 - less, less, n) : 0.0;
}
