// What the effects give to the whole triangle: its last vertex's value (OpenGL's provoking vertex).
flat in vec3 radiance;

vec3 interpolated_radiance()
{
    return radiance;
}
