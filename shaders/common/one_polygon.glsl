// A triangle in the place of the scene's polygons (common/polygons), for probes of functions of one.
vec3 vertices[3];

// P is 0 without rounding: that of the vertices is left.
const float POLYGON_UNITS = 2.0;

vec3 polygon_vertex(int i)
{
    return vertices[i];
}
