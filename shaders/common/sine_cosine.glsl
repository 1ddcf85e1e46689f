// Sine and cosine of x in [0, pi/2], each accurate relative to itself: GLSL promises an absolute error only. Taylor's series to pi/4, and beyond
// for what is left to pi/2, which the nearest number exceeds by 4.371e-8: that one is taken as pi/2, and its cosine is 0.
vec2 sine_cosine(float x)
{
    precise float rest = 1.57079637 - x;
    rest -= 4.37113883e-8;
    bool beyond = x > 0.785398163;
    float r = beyond ? max(rest, 0.0) : x;
    float z = r * r;
    float s = r + r * z * (-1.0 / 6.0 + z * (1.0 / 120.0 + z * (-1.0 / 5040.0 + z / 362880.0)));
    float c = 1.0 + z * (-0.5 + z * (1.0 / 24.0 + z * (-1.0 / 720.0 + z * (1.0 / 40320.0 - z / 3628800.0))));
    return beyond ? vec2(c, s) : vec2(s, c);
}
