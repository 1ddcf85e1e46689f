// The point of the surface that this pixel shows.
in vec3 world_position;
in vec3 world_normal;

uniform vec3 eye;

Surface surface_here()
{
    return Surface(world_position, normalize(world_normal), normalize(eye - world_position));
}
