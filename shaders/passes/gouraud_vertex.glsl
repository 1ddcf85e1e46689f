// The vertices of an object whose effects are evaluated here (Gouraud 1971). The position is as in object_vertex, to the bit: passes that
// follow find its depths.
// Where a light is at a vertex what it gives may be beyond single precision, and interpolation takes differences of it over a pixel's width:
// at most 1e30, in C as well (src/reference/interpolated.c).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 clip_from_world;
uniform vec3 eye;

out vec3 world_position;
out vec3 world_normal;
out vec3 radiance;
invariant gl_Position;

void main()
{
    world_position = position;
    world_normal = normal;
    radiance = min(shade_lights(Surface(position, normalize(normal), normalize(eye - position))), vec3(1e30));
    gl_Position = clip_from_world * vec4(position, 1.0);
}
