// The lights' polygons as one face of a cube map sees them. The rows of `face` are the directions of the
// face's s, t and outward axes (OpenGL 4.5, table 8.19). Depth is near/distance, which keeps its precision at
// any ratio of distances; the nearest is the greatest.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 radiance;

uniform mat3 face;
uniform vec3 centre;
uniform float near_plane;

flat out vec3 texel;

void main()
{
    vec3 p = face * (position - centre);
    texel = radiance;
    gl_Position = vec4(p.xy, near_plane, p.z);
}
