/* Every polygon of every light, flattened for the integrators. Read-only once made. */
#ifndef RL_REFERENCE_LIGHT_SET_H
#define RL_REFERENCE_LIGHT_SET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "model/vec3.h"
#include "reference/integrator.h"

struct rl_set_polygon {
    size_t first, n; /* vertices */
    size_t
        radiance; /* index; lights of equal radiance share one, since which of them is seen makes no difference */
    rl_vec3 normal;   /* unit; counter-clockwise seen from its tip */
    double thickness; /* how far any vertex lies off the plane, and what rounding adds */
    rl_vec3 most;     /* rl_plane_most */
};

/* What lies across an edge. */
struct rl_twin {
    size_t polygon; /* RL_NO_TWIN: none, or more than one */
    bool opposite;  /* it runs along the edge the other way, as neighbours in a mesh do */
};
#define RL_NO_TWIN SIZE_MAX

struct rl_light_set {
    size_t n_polygons, n_vertices, n_radiances;
    struct rl_set_polygon *polygon;
    rl_vec3 *vertex;
    rl_vec3 *
        edge; /* from each vertex to the next of its polygon: taken before P is, exact for far small lights */
    struct rl_twin *twin; /* of each edge; NULL unless there are several polygons, all of one radiance */
    double (*radiance)[3];
    double brightest;                      /* component of any radiance */
    size_t whole_polygons, whole_vertices; /* of all lights, kept or not */
    bool grey;                             /* the components of each radiance are equal */
    double unit; /* of rounding of the points that see them (model/plane.h); RL_UNIT_DOUBLE as made */
};

/* Of these lights only those of the indices `kept`, ascending, for the others are nowhere to be seen: what the integral of those that are
 * depends on, radiances and tolerance and whether it matters which light is nearest, is as with all, and so is every bit of it. */
int rl_light_set_make_kept(struct rl_light_set **set, const struct rl_light *lights, size_t n_lights,
                           const size_t *kept, size_t n_kept, struct rl_error *error);

/* Finds the twins (twins.c). */
int rl_light_set_find_twins(struct rl_light_set *set, struct rl_error *error);

#endif
