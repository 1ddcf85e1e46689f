// The highlight as the listing has it: |cos(psi + theta)|, since squaring loses the sign.
float fur_cone(vec3 n, vec3 l, vec3 e)
{
    return abs(fur_sine(n, l) * fur_sine(n, e) + dot(n, l) * dot(n, e));
}
