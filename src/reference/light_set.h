/* Every polygon of every light, flattened for the integrators. Read-only once made. */
#ifndef RL_REFERENCE_LIGHT_SET_H
#define RL_REFERENCE_LIGHT_SET_H

#include <stdbool.h>
#include <stddef.h>

#include "model/vec3.h"
#include "reference/integrator.h"

struct rl_set_polygon {
    size_t first, n; /* vertices */
    size_t
        radiance; /* index; lights of equal radiance share one, since which of them is seen makes no difference */
    rl_vec3 normal;   /* unit; counter-clockwise seen from its tip */
    double thickness; /* how far any vertex lies off the plane, and what rounding adds */
};

struct rl_light_set {
    size_t n_polygons, n_vertices, n_radiances;
    struct rl_set_polygon *polygon;
    rl_vec3 *vertex;
    rl_vec3 *
        edge; /* from each vertex to the next of its polygon: taken before P is, exact for far small lights */
    double (*radiance)[3];
    double brightest; /* component of any radiance */
    bool grey;        /* the components of each radiance are equal */
};

#endif
