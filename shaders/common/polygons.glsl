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

vec3 polygon_vertex(int i)
{
    return polygon_vertices[i].xyz;
}
