// The vertices of an object whose effects are evaluated once a triangle, at its centroid for the normal of its plane (Bouknight 1970). Each
// triangle has a last vertex of its own, which carries them. The position is as in object_vertex, to the bit: passes that follow find its depths.
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
invariant gl_Position;

void main()
{
    world_position = position;
    world_normal = normal;
    radiance = min(shade_lights(Surface(facet_centre, facet_normal, normalize(eye - facet_centre))), vec3(1e30));
    gl_Position = clip_from_world * vec4(position, 1.0);
}
