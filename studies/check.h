/* The small fixed set of cases whose error metrics are held against a baseline (`roughlight study check`): the model's functions, the
 * reference at points and in pictures, normal maps, and pictures of every method.
 *
 *     struct rl_check *check;
 *     rl_check_open(&check, "auto", 0, progress, &error);
 *     rl_check_measure(&now, check, &(struct rl_check_options){.first_seed = 1, .seeds = 16, .fixed = true}, &error);
 *     rl_check_close(check);
 *
 * Cases name only what differs from the paper's settings (RL_SETTINGS_DEFAULT), so that the defaults are checked too.
 */
#ifndef RL_STUDIES_CHECK_H
#define RL_STUDIES_CHECK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "base/progress.h"
#include "results/baseline.h"
#include "results/provenance.h"

enum { RL_CHECK_SEEDS_MAX = 1024 };

struct rl_check_options {
    uint64_t first_seed; /* each case has its own 2^32 from there on, of which it takes the first `seeds` */
    size_t seeds;        /* even, 4 to RL_CHECK_SEEDS_MAX: pictures are taken in pairs */
    bool random, fixed;  /* which metrics */
    bool tolerances;     /* of fixed pictures too, which takes six more frames each: for a new baseline */
    const char *const *scene; /* only cases of these n_scenes; n_scenes 0: all */
    size_t n_scenes;
};

/* Whether cases of this scene are asked for. */
bool rl_check_wants(const struct rl_check_options *options, const char *scene);
/* RL_ERR_INPUT names a scene of the options that no case has, and those that there are. */
int rl_check_options_check(const struct rl_check_options *options, struct rl_error *error);

struct rl_check;

/* `progress` must outlive the check. Scenes and references are made when first needed and kept until it is closed. */
int rl_check_open(struct rl_check **check, const char *backend, int threads,
                  const struct rl_progress *progress, struct rl_error *error);
/* NULL is fine. */
void rl_check_close(struct rl_check *check);

const struct rl_provenance *rl_check_provenance(const struct rl_check *check);

/* Adds a row for every metric to `now`. A case that fails has no rows and is noted (rl_check_failures); that is no error here.
 * RL_ERR_CANCELLED, RL_ERR_SYSTEM end it. RL_ERR_INPUT: as rl_check_options_check. */
int rl_check_measure(struct rl_baseline *now, struct rl_check *check, const struct rl_check_options *options,
                     struct rl_error *error);

/* Lines "SCENE PARAMETERS: why" of the last rl_check_measure, each ended; "" if all went well. */
const char *rl_check_failures(const struct rl_check *check);

#endif
