// Goldman's kappa: the cosine of the angle about n between light and eye; 0 where n is parallel to either.
float fur_kappa(vec3 n, vec3 l, vec3 e)
{
    vec3 a = cross(n, l);
    vec3 b = cross(n, e);
    // Rounding alone is clamped.
    return clamp(dot(a, b) / (max(length(a), 1e-4) * max(length(b), 1e-4)), -1.0, 1.0);
}
