// The ellipsoid distribution of microfacet normals over solid angle (src/model/facets.h); m = 1/R_r.
float facets(float cos_delta, float sin_sin, float m)
{
    float q = m / (m * m * cos_delta * cos_delta + sin_sin);
    return q * q / 3.14159265;
}
