// Ambient light: k_a I_a with I_a = 1, the same from everywhere.
uniform vec4 ambient_params[1];

vec3 effect_ambient(Surface s)
{
    return ambient_params[0].rgb;
}
