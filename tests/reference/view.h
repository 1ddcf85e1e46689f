/* Lights as seen from one point, with the memory that takes. */
#ifndef TESTS_REFERENCE_VIEW_H
#define TESTS_REFERENCE_VIEW_H

#include <stdlib.h>

#include "reference/fixture.h"
#include "reference/lines.h"

struct view {
    struct rl_surface s;
    struct rl_ellipsoid e;
    struct rl_integrate_options options;
    struct rl_light_set *set;
    void *memory;
    struct rl_lines lines;
};

static inline void view_make(struct view *v, struct rl_surface s, double rr, const struct shape *shapes,
                             const double *radiance, size_t n, bool attenuation)
{
    v->s = s;
    v->e = rl_ellipsoid_make(rr);
    v->options = (struct rl_integrate_options){.attenuation = attenuation};
    v->set = radiance ? lights_of(shapes, radiance, n) : set_of(shapes, n);
    v->memory = malloc(rl_lines_size(v->set));
    rl_lines_make(&v->lines, v->memory, &v->s, &v->e, v->set, &v->options);
}

static inline void view_clear(struct view *v)
{
    free(v->memory);
    rl_light_set_free(v->set);
}

#endif
