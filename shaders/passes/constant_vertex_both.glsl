// The same as constant_vertex where back faces are seen, too: these are shaded with the normal turned round.
// At most 1e30, as in gouraud_vertex.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 facet_centre;
layout(location = 3) in vec3 facet_normal;

uniform mat4 clip_from_world;
uniform vec3 eye;

out vec3 world_position;
out vec3 world_normal;
flat out vec3 radiance;
flat out vec3 radiance_behind;
invariant gl_Position;

void main()
{
    world_position = position;
    world_normal = normal;
    vec3 V = normalize(eye - facet_centre);
    radiance = min(shade_lights(Surface(facet_centre, facet_normal, V)), vec3(1e30));
    radiance_behind = min(shade_lights(Surface(facet_centre, -facet_normal, V)), vec3(1e30));
    gl_Position = clip_from_world * vec4(position, 1.0);
}
