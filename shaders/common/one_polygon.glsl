// A triangle in the place of the scene's polygons (common/polygons), for probes of functions of one.
vec3 vertices[3];

vec3 polygon_vertex(int i)
{
    return vertices[i];
}
