// The highlight as the listing has it: |cos(psi + theta)|^p, since squaring loses the sign.
float fur_cone(vec3 n, vec3 l, vec3 e, float p)
{
    float s_l = fur_sine(n, l);
    float s_e = fur_sine(n, e);
    float c_l = dot(n, l);
    float c_e = dot(n, e);
    return fur_power(s_l * c_e - c_l * s_e, abs(s_l * s_e + c_l * c_e), p);
}
