/* What a study's cases cost in time where nothing like them was measured yet: a first estimate, from how much there is to do.
 *
 *     static const struct rl_cost costs[] = {{.pattern = "series=time", .picture = 0.0014, .pixel = 0.086},
 *                                            {.pattern = "", .picture = 0.0017, .sample = 0.037}};
 *     double seconds = rl_cost_seconds(costs, 2, &run->record[first], n);
 *
 * The rates are of two cores of an AMD EPYC and Mesa's llvmpipe: least squares over groups of the quick and default grids, no rate
 * negative. What a study's default grid took there is right within a factor of two; a single group may be off by five, and what is
 * far from those grids by more. Another machine is another factor: as soon as something is measured, that counts.
 */
#ifndef RL_STUDIES_COST_H
#define RL_STUDIES_COST_H

#include <stddef.h>

#include "results/record.h"

/* Rates in seconds; what a study has no use for is 0. */
struct rl_cost {
    const char *pattern; /* the first case of the groups that it is for (rl_parameters_match); "": all */
    double group;        /* each group */
    double picture;      /* each picture or frame timed: seeds x views + rounds + frames */
    double
        pixel; /* a million of their pixels or points: width x height (frames timed: timed_width x timed_height), size^2 or points */
    double sample; /* a million times those pixels' samples */
    double texel;  /* a million texels of normal maps: normal_size^2, one for each seed */
    double second; /* each second that a case is told to be timed (seconds) */
};

/* The seconds of a group of n cases by the first cost whose pattern its first case matches; NaN: there is none. */
double rl_cost_seconds(const struct rl_cost *costs, size_t n_costs, const struct rl_record *group, size_t n);

#endif
