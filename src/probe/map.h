/* Maps of hard cases: a probe's exact answers over a grid of two of its arguments, and how far a backend is from them.
 *
 *     struct rl_map m;
 *     rl_map_load(&m, "tests/hard/maps/attenuation.tsv", &error);
 *     rl_catalogue_evaluate(&m.catalogue, NULL, results, &error);
 *     rl_map_point_of(&m, RL_CATALOGUE_CPU, results, i)           of point i, what the catalogue's judge says
 *     rl_map_free(&m);
 *
 * A file NAME.tsv is of the probe NAME. tests/hard/exact_map.c writes it and says what its lines are. Arguments are numbers of single
 * precision, so that one exact answer serves both backends.
 */
#ifndef RL_PROBE_MAP_H
#define RL_PROBE_MAP_H

#include "probe/catalogue.h"

enum { RL_MAP_ACROSS, RL_MAP_UP, RL_MAP_AXES };

struct rl_map {
    struct rl_catalogue catalogue; /* a row for each point, those across first; `why` is NULL */
    size_t n[RL_MAP_AXES];
    double *shown[RL_MAP_AXES]; /* what stands at the axis: n numbers */
    size_t n_judged, judged[RL_PROBE_OUT_MAX];
    bool absolute; /* errors count in the last place of 1, not in that of the answer */
};

/* Of one point: the worst of the results that are judged. */
struct rl_map_point {
    double ulp, share;
    bool widened; /* a result is beyond the plain bound, by no more than its arguments' rounding allows */
};

/* RL_ERR_INPUT with file and line, RL_ERR_SYSTEM: as rl_catalogue_load. */
int rl_map_load(struct rl_map *m, const char *path, struct rl_error *error);
void rl_map_free(struct rl_map *m);

/* The folder of the maps that come with the program; rl_catalogue_list lists it. */
int rl_map_folder(char path[], size_t size, struct rl_error *error);

/* `results` are those of all points. */
struct rl_map_point rl_map_point_of(const struct rl_map *m, enum rl_catalogue_backend backend,
                                    const double *results, size_t point);

#endif
