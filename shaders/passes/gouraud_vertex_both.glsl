// The same as gouraud_vertex where back faces are seen, too: these are shaded with the normal turned round.
// Where a light is at a vertex what it gives may be beyond single precision, and interpolation takes differences of it over a pixel's width:
// at most 1e30, in C as well (src/reference/interpolated.c).
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 clip_from_world;
uniform vec3 eye;

out vec3 world_position;
out vec3 world_normal;
out vec3 radiance;
out vec3 radiance_behind;
invariant gl_Position;

void main()
{
    world_position = position;
    world_normal = normal;
    vec3 N = normalize(normal);
    vec3 V = normalize(eye - position);
    radiance = min(shade_lights(Surface(position, N, V)), vec3(1e30));
    radiance_behind = min(shade_lights(Surface(position, -N, V)), vec3(1e30));
    gl_Position = clip_from_world * vec4(position, 1.0);
}
