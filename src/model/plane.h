/* How far a polygon's plane lies off a point, and the one convention for points that lie in it: those see nothing of the polygon.
 *
 * A point counts as in the plane where the rounding of coordinates decides the side it is on: where the distance is below
 *
 *     16 x unit x (|n_x| X + |n_y| Y + |n_z| Z),      n the plane's unit normal; X the largest |x| of P and of the vertices, Y and Z alike
 *
 * or no more than the polygon's own corners lie off one plane. It is counted axis by axis: of a plane z = 1e-12 the distance is known
 * however large x and y are. `unit` is what a 1 is rounded by, 2^-52 for coordinates in double precision. Points of meshes are those of
 * single precision, 2^-23, and so is everything in GLSL (shaders/common/plane.glsl): rotated, a floor and a light in one plane lie 1e-8 apart
 * here and there, on either side. (Probes have P = 0 exactly and in GLSL 2 units in place of the 16.) A mesh may be some 30 times as large as P's coordinates and the polygon's are, then its rounding shows.
 */
#ifndef RL_MODEL_PLANE_H
#define RL_MODEL_PLANE_H

#include <float.h>
#include <stddef.h>

#include "model/vec3.h"

#define RL_UNIT_DOUBLE DBL_EPSILON
#define RL_UNIT_SINGLE ((double)FLT_EPSILON)

#define RL_PLANE_UNITS 16.0

/* n.(v_0 - P), in the coordinates' units, n by the right hand along the outline; 0: P is in the plane. n_vertices >= 3. */
double rl_plane_distance(const rl_vec3 *v, size_t n_vertices, rl_vec3 P, double unit);

/* The bound above but for the corners', of a vector n of any length; `most` are X, Y and Z of the vertices. */
static inline double rl_plane_rounding(rl_vec3 n, rl_vec3 most, rl_vec3 P, double unit)
{
    return RL_PLANE_UNITS * unit *
           (fabs(n.x) * fmax(most.x, fabs(P.x)) + fabs(n.y) * fmax(most.y, fabs(P.y)) +
            fabs(n.z) * fmax(most.z, fabs(P.z)));
}

/* X, Y and Z of the vertices. */
static inline rl_vec3 rl_plane_most(const rl_vec3 *v, size_t n)
{
    rl_vec3 most = v3(0.0, 0.0, 0.0);
    for (size_t i = 0; i < n; i++)
        most = v3(fmax(most.x, fabs(v[i].x)), fmax(most.y, fabs(v[i].y)), fmax(most.z, fabs(v[i].z)));
    return most;
}

#endif
