// Every polygon of every shaped light (struct rl_area_light): its radiance, the first of its vertices and how many.
struct Polygon {
    vec4 radiance;
    ivec4 range;
};

layout(std430, binding = 0) readonly buffer Polygons
{
    Polygon polygons[];
};
layout(std430, binding = 1) readonly buffer PolygonVertices
{
    vec4 polygon_vertices[];
};

// How many units of rounding, 2^-23, of coordinates the points seeing them may be off a plane they are in: RL_PLANE_UNITS of src/model/plane.h.
const float POLYGON_UNITS = 16.0;

vec3 polygon_vertex(int i)
{
    return polygon_vertices[i].xyz;
}
