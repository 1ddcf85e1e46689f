/* The check's cases of the study `distribution`: what its generators make of one point. Seeds are taken in pairs, as those of pictures. */
#include <inttypes.h>
#include <math.h>

#include "studies/check_parts.h"
#include "studies/distribution.h"

enum figure { BIAS, NOISE, FIGURES };

static const char *const name[FIGURES] = {[BIAS] = "bias", [NOISE] = "noise"};

static int measure_pair(double value[FIGURES], const char *parameters, uint64_t seed, struct rl_bench *bench,
                        struct rl_error *error)
{
    struct rl_record r = {0};
    snprintf(r.parameters, sizeof r.parameters, "%s seeds=2 seed=%" PRIu64, parameters, seed);
    int status = rl_distribution_measure_generator(&r, bench, error);
    for (int i = 0; i < FIGURES && status == RL_OK; i++) {
        const struct rl_metric *m = rl_record_metric(&r, name[i]);
        value[i] = m ? m->value : NAN;
    }
    rl_record_reset(&r);
    return status;
}

int rl_check_generator(struct rl_check_rows *rows, const struct rl_check_case *c,
                       struct rl_check_context *context)
{
    double value[FIGURES][RL_CHECK_SEEDS_MAX / 2];
    size_t n = context->options->seeds / 2;
    for (size_t k = 0; k < n; k++) {
        double pair[FIGURES];
        int status =
            measure_pair(pair, c->parameters, context->first_seed + 2 * k, context->bench, rows->error);
        if (status != RL_OK)
            return status;
        for (int i = 0; i < FIGURES; i++)
            value[i][k] = pair[i];
    }
    double noise = rl_mean_of(value[NOISE], n).value;
    rl_check_random(rows, name[BIAS], RL_BEST_ZERO, value[BIAS], n, 0.05 * noise);
    rl_check_random(rows, name[NOISE], RL_BEST_LOWER, value[NOISE], n, 0.1 * noise);
    return rows->status;
}
