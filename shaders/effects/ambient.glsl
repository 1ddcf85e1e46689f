// Ambient light: k_a I_a with I_a = 1, the same from everywhere.
//
// params: k_a.

vec3 constant_ambient(vec4 params[1])
{
    return params[0].rgb;
}
