// The angle, 0 to pi, whose sine and cosine are in the ratio of y >= 0 and x; 0 for 0, 0. GLSL's own atan is off by 2e-5 of the angle in
// some implementations, and differences of angles are what matters. A polynomial for arctangents up to 1, interpolated at Chebyshev's
// points; relative error 8e-8.
float angle_of(float y, float x)
{
    float least = min(y, abs(x));
    float most = max(y, abs(x));
    float t = most > 0.0 ? least / most : 0.0;
    float z = t * t;
    float p = -0.00244703119;
    p = p * z + 0.0137502842;
    p = p * z - 0.0362701742;
    p = p * z + 0.0628436091;
    p = p * z - 0.0867317087;
    p = p * z + 0.110379943;
    p = p * z - 0.142791109;
    p = p * z + 0.19999766;
    p = p * z - 0.33333332;
    float angle = t + t * (z * p);
    angle = y > abs(x) ? 1.57079633 - angle : angle;
    return x < 0.0 ? 3.14159265 - angle : angle;
}
