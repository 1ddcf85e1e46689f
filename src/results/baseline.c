/* Baselines in memory, and their comparison (see baseline.h). */
#include "results/baseline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "measure/goodness.h"

int rl_baseline_add(struct rl_baseline *b, const struct rl_baseline_row *row, struct rl_error *error)
{
    if (b->n == b->capacity) {
        size_t capacity = b->capacity ? 2 * b->capacity : 64;
        struct rl_baseline_row *more = realloc(b->row, capacity * sizeof *more);
        if (!more)
            return rl_fail_memory(error, "a baseline");
        b->row = more;
        b->capacity = capacity;
    }
    b->row[b->n++] = *row;
    return RL_OK;
}

const struct rl_baseline_row *rl_baseline_find(const struct rl_baseline *b,
                                               const struct rl_baseline_row *like)
{
    for (size_t i = 0; i < b->n; i++)
        if (strcmp(b->row[i].metric, like->metric) == 0 && strcmp(b->row[i].scene, like->scene) == 0 &&
            strcmp(b->row[i].parameters, like->parameters) == 0)
            return &b->row[i];
    return NULL;
}

void rl_baseline_clear(struct rl_baseline *b)
{
    free(b->row);
    *b = (struct rl_baseline){0};
}

/* Why the two cannot be compared; NULL if they can. */
static const char *incomparable(const struct rl_baseline_row *before, const struct rl_baseline_row *now)
{
    if (!before)
        return "not in the baseline";
    if (!now)
        return "not measured now";
    if (before->kind != now->kind || before->best != now->best || strcmp(before->unit, now->unit) != 0)
        return "kind, unit or what is best differs";
    if (strcmp(before->scene_hash, now->scene_hash) != 0)
        return "the scene has changed";
    return NULL;
}

/* "llvmpipe (LLVM 15.0.6, 256 bits)": the family is the first word. */
static bool same_family(const char *a, const char *b)
{
    size_t length = strcspn(a, " ,");
    return length == strcspn(b, " ,") && strncmp(a, b, length) == 0;
}

static void compare_fixed(struct rl_regression *r, const struct rl_baseline_row *before,
                          const struct rl_baseline_row *now)
{
    rl_regression_fixed(r, before->mean.value, now->mean.value, now->best, before->tolerance);
    bool changed = r->verdict == RL_CHANGE_WORSE || r->verdict == RL_CHANGE_BETTER;
    if (changed && isfinite(now->mean.value) && now->drawn && !same_family(before->renderer, now->renderer)) {
        r->verdict = RL_CHANGE_INCOMPARABLE;
        r->reason = "another renderer";
    }
}

static void compare_row(struct rl_compared *c, double level)
{
    const char *reason = incomparable(c->before, c->now);
    if (reason)
        c->result = (struct rl_regression){RL_CHANGE_INCOMPARABLE, NAN, NAN, NAN, NAN, reason};
    else if (c->now->kind == RL_METRIC_FIXED)
        compare_fixed(&c->result, c->before, c->now);
    else
        rl_regression_random(&c->result, &c->before->mean, &c->now->mean, c->now->best, c->before->relevant,
                             level);
}

/* Every figure of either side once. */
static void pair(struct rl_comparison *c, const struct rl_baseline *before, const struct rl_baseline *now)
{
    for (size_t i = 0; i < now->n; i++) {
        const struct rl_baseline_row *found = rl_baseline_find(before, &now->row[i]);
        c->row[c->n++] = (struct rl_compared){.before = found, .now = &now->row[i]};
        c->n_tests += now->row[i].kind == RL_METRIC_RANDOM && !incomparable(found, &now->row[i]);
    }
    for (size_t i = 0; i < before->n; i++)
        if (!rl_baseline_find(now, &before->row[i]))
            c->row[c->n++] = (struct rl_compared){.before = &before->row[i]};
}

int rl_baseline_compare(struct rl_comparison *c, const struct rl_baseline *before,
                        const struct rl_baseline *now, double level, struct rl_error *error)
{
    *c = (struct rl_comparison){.row = calloc(before->n + now->n + 1, sizeof *c->row), .p_family = 1.0};
    if (!c->row)
        return rl_fail_memory(error, "a comparison");
    pair(c, before, now);
    c->level = c->n_tests ? rl_sidak_level(level, (double)c->n_tests) : level;
    double smallest = 1.0;
    for (size_t i = 0; i < c->n; i++) {
        compare_row(&c->row[i], c->level);
        c->count[c->row[i].result.verdict]++;
        smallest = fmin(smallest, c->row[i].result.p); /* fmin leaves NaN out */
    }
    if (c->n_tests)
        c->p_family = rl_sidak_p(smallest, (double)c->n_tests);
    return RL_OK;
}

void rl_comparison_clear(struct rl_comparison *c)
{
    free(c->row);
    *c = (struct rl_comparison){0};
}
