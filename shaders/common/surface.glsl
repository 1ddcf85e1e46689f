// The visible point as effects and methods see it: position, unit shading normal, unit direction to the eye.
struct Surface {
    vec3 P, N, V;
};

in vec3 world_position;
in vec3 world_normal;

uniform vec3 eye;

Surface surface_here()
{
    return Surface(world_position, normalize(world_normal), normalize(eye - world_position));
}
