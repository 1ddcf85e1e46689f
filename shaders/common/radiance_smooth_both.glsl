// The same where back faces are seen, too, each side by its own shading.
in vec3 radiance;
in vec3 radiance_behind;

vec3 interpolated_radiance()
{
    return gl_FrontFacing ? radiance : radiance_behind;
}
