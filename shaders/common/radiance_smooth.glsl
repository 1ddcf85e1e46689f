// What the effects give at the vertices, interpolated to this pixel: linear on the triangle, in perspective too (Gouraud).
in vec3 radiance;

vec3 interpolated_radiance()
{
    return radiance;
}
