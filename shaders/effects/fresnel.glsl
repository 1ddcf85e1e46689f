// Fresnel's reflectance at the angle between N and V, a factor on the highlight of shaped lights.
//
// params: n; k; n^2 - 1.

vec3 factor_fresnel(Surface s, vec4 params[3])
{
    // The sine by itself: near normal incidence the cosine does not know it.
    vec3 across = cross(s.N, s.V);
    float n_v = clamp(dot(s.N, s.V), 0.0, 1.0);
    // From behind as at 90 degrees.
    float sin_sin = n_v > 0.0 ? dot(across, across) : 1.0;
    return fresnel(params[0].rgb, params[1].rgb, params[2].rgb, n_v, sin_sin);
}
