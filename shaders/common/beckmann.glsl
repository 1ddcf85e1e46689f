// Beckmann's distribution of microfacet normals over solid angle (src/model/facets.h); m: rms slope.
float facets(float cos_delta, float sin_sin, float m)
{
    float cc = cos_delta * cos_delta;
    float mm = m * m;
    // Past 80 the exponential is below anything that single precision would add to.
    if (!(sin_sin < 80.0 * mm * cc))
        return 0.0;
    return exp(-sin_sin / (cc * mm)) / (3.14159265 * mm * cc * cc);
}
