/* How far a light's polygon lies off a point, with its sign right also where the point is all but in its plane.
 *
 *     double distance = rl_side_distance(set, &set->polygon[i], P);
 *
 * Where the difference of two products would be rounding it is computed in twice the precision (model/plane.c).
 */
#ifndef RL_REFERENCE_SIDE_H
#define RL_REFERENCE_SIDE_H

#include "reference/light_set.h"

/* normal.(vertex - P), in the scene's units: > 0 where the normal points away from P. 0: seen edge-on, it covers nothing; so it is where P
 * lies no further off than the polygon's own corners do of one plane, or than the rounding of the coordinates may put it (model/plane.h). */
double rl_side_distance(const struct rl_light_set *set, const struct rl_set_polygon *polygon, rl_vec3 P);

#endif
