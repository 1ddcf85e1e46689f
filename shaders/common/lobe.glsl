// Powers of cosines, the lobes of highlights (src/model/lobe.h):
//
//     cos^n = (1 + tan^2)^(-n/2)
//
// by the squares of sine and cosine but for a common factor: cosine_square > 0 and n >= 1. GLSL's own pow is off by 1e-4 and more near 1 in some
// implementations, for their logarithm is. Here log2(1 + f) = (2/ln 2) atanh(f/(2 + f)), with f = tan^2 itself below sqrt(2) - 1 and what is
// left after a power of two above: three terms, fitted; relative error 1.2e-7.
float power_of_cosine(float sine_square, float cosine_square, float n)
{
    // Past 1e18 the power is below 1e-9.
    float tan_square = min(sine_square / cosine_square, 1e18);
    float x = 1.0 + tan_square;
    int exponent = (floatBitsToInt(x) - 0x3f3504f3) >> 23; // of x = m 2^exponent, m from sqrt(1/2) to sqrt(2)
    float f = exponent == 0 ? tan_square : intBitsToFloat(floatBitsToInt(x) - (exponent << 23)) - 1.0;
    float s = f / (2.0 + f);
    float z = s * s;
    float log2_x = float(exponent) + s * (2.88539042 + z * (0.961588912 + z * 0.595761199));
    return exp2(-0.5 * n * log2_x);
}
