// Kajiya and Kay's highlight: cos(psi - theta), 0 where the eye is more than 90 degrees off the cone.
float fur_cone(vec3 n, vec3 l, vec3 e)
{
    return max(0.0, fur_sine(n, l) * fur_sine(n, e) - dot(n, l) * dot(n, e));
}
