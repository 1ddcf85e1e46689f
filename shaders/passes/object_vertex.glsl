// The vertices of an object, in world space. Every pass over objects uses this one module, and the position
// is invariant: passes after the first find exactly the depths of the first.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 clip_from_world;

out vec3 world_position;
out vec3 world_normal;
invariant gl_Position;

void main()
{
    world_position = position;
    world_normal = normal;
    gl_Position = clip_from_world * vec4(position, 1.0);
}
