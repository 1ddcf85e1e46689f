// Terms of fur models: fibres along n, unit l to the light and e to the eye. The equations are in src/model/fur.h.
float fur_sine(vec3 n, vec3 a)
{
    return length(cross(n, a));
}

// x^n for x from 0 to 1, n >= 1.
float fur_power(float x, float n)
{
    return x > 0.0 ? pow(min(x, 1.0), n) : 0.0;
}
