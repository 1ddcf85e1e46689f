/* Pictures of one case that differ in nothing but their seed, and what follows from them: error, noise and floor.
 *
 *     struct rl_seeds s = {0};
 *     rl_seeds_draw(&s, bench, set, 16, &error);
 *     rl_seeds_add_error(record, &s, truth, centre, &error);
 *     rl_seeds_clear(&s);
 */
#ifndef RL_STUDIES_SEEDS_H
#define RL_STUDIES_SEEDS_H

#include "base/error.h"
#include "image/image.h"
#include "measure/metrics.h"
#include "results/record.h"
#include "studies/bench.h"

enum { RL_SEEDS_MAX = 64 };

struct rl_seeds {
    size_t n;
    struct rl_image image[RL_SEEDS_MAX];
};

/* A study's check: whether the parameter `seeds` is a number that rl_seeds_draw takes. */
int rl_seeds_check(const char *parameters, struct rl_error *error);

/* Draws `set` with the seeds 1 to n. RL_ERR_INPUT: n is not a whole number from 1 to RL_SEEDS_MAX. What is drawn until an error is in `s`,
 * which must be empty before and is cleared by the caller in any case. */
int rl_seeds_draw(struct rl_seeds *s, struct rl_bench *bench, struct rl_bench_scene *set, double n,
                  struct rl_error *error);
/* The same of a scene that is set up for it, with as many seeds as the case's parameters say. */
int rl_seeds_draw_case(struct rl_seeds *s, struct rl_bench *bench, const struct rl_scene *scene,
                       const char *parameters, struct rl_error *error);
void rl_seeds_clear(struct rl_seeds *s);

/* a - b seed by seed, covered where both are; as many as both have. `difference` must be empty before and is cleared by the caller in any
 * case. RL_ERR_INPUT: sizes differ. */
int rl_seeds_difference(struct rl_seeds *difference, const struct rl_seeds *a, const struct rl_seeds *b,
                        struct rl_error *error);

/* Squared error over seeds, split into bias and variance. One picture of a fixed pattern has no noise: all its error is
 * bias. `reference` NULL: against zero, for differences. */
int rl_seeds_split(struct rl_bias_variance *split, const struct rl_seeds *s, const struct rl_image *reference,
                   struct rl_error *error);

/* Adds rmse, mae, bias, relmse (means over seeds with their intervals), max, pixels and mismatched against `truth`; bias2 and
 * variance, and their roots floor and noise; against `centre`, which sees the lights from the object's centre, rmse_centre and
 * floor_centre; and parallax, the RMSE between the two. One picture alone, and parallax, are as sure as the references: to within the
 * record's parameter `tolerance` of each. RL_ERR_CHECK: values that are not finite. */
int rl_seeds_add_error(struct rl_record *record, const struct rl_seeds *s, const struct rl_image *truth,
                       const struct rl_image *centre, struct rl_error *error);

/* Root of what may come out slightly negative. */
double rl_root(double x);

#endif
