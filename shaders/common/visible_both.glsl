// The point of the surface that this pixel shows, from whichever side it is seen: of a back face the normal is turned to the eye's side.
in vec3 world_position;
in vec3 world_normal;

uniform vec3 eye;

Surface surface_here()
{
    vec3 N = normalize(world_normal);
    return Surface(world_position, gl_FrontFacing ? N : -N, normalize(eye - world_position));
}
