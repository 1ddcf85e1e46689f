// Terms of fur models: fibres along n, unit l to the light and e to the eye. The equations are in src/model/fur.h.
float fur_sine(vec3 n, vec3 a)
{
    return length(cross(n, a));
}

// cos^p of the angle of this sine and cosine; 0 where the cosine is not above 0. 1 - cos = ((1 - cos)^2 + sin^2)/2, half the chord's square.
float fur_power(float sine, float cosine, float p)
{
    float less = 0.5 * ((1.0 - cosine) * (1.0 - cosine) + sine * sine);
    return cosine > 0.0 ? power(cosine, less, p) : 0.0;
}
