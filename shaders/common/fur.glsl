// Terms of fur models: fibres along n, unit l to the light and e to the eye. The equations are in src/model/fur.h.
float fur_sine(vec3 n, vec3 a)
{
    return length(cross(n, a));
}

// cos^p of the angle of this sine and cosine; 0 where the cosine is not above 0.
float fur_power(float sine, float cosine, float p)
{
    return cosine > 0.0 ? power_of_cosine(sine * sine, cosine * cosine, p) : 0.0;
}
