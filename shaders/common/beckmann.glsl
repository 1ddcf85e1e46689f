// Beckmann's distribution of microfacet normals over solid angle (src/model/facets.h); m: rms slope.
float facets(float cos_delta, float sin_sin, float m)
{
    float cc = cos_delta * cos_delta;
    float x = sin_sin / (cc * m * m);
    // Past 80 the exponential is below anything that single precision would add to.
    if (!(x < 80.0))
        return 0.0;
    float root = exp(-0.5 * x) / (m * cc);
    return root * root / 3.14159265;
}
