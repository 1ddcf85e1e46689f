/* On which side of a polygon's plane a point lies (see side.h). Plain arithmetic tells where the distance is well above its own rounding and
 * the coordinates', and that is nearly always. */
#include "reference/side.h"

#include "model/plane.h"

double rl_side_distance(const struct rl_light_set *set, const struct rl_set_polygon *polygon, rl_vec3 P)
{
    const rl_vec3 *vertex = &set->vertex[polygon->first];
    rl_vec3 first = v3_sub(vertex[0], P);
    double distance = v3_dot(polygon->normal, first);
    double rounding = rl_plane_rounding(polygon->normal, polygon->most, P, set->unit);
    if (fabs(distance) > polygon->thickness + 1e-15 * v3_length(first) + 2.0 * rounding)
        return distance;
    return rl_plane_distance(vertex, polygon->n, P, set->unit);
}
