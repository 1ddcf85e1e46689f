/* The claims that the study `hard` judges: whether bounds are kept. Nothing in it is random, so each value is its own interval. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/hard.h"
#include "studies/judging.h"

static const char *const in_words[] = {[RL_CATALOGUE_CPU] = "C", [RL_CATALOGUE_GPU] = "GLSL"};

/* One metric of a record, NaN if it has none. */
static double value(const struct rl_record *r, const char *name)
{
    const struct rl_metric *m = rl_record_metric(r, name);
    return m ? m->value : NAN;
}

/* What the rows of one backend come to. */
struct sum {
    double rows, failed;
    size_t functions;
    char worst[RL_NAME_MAX]; /* function */
    double line;
};

static int claim_rows(const struct rl_judging *j, enum rl_catalogue_backend backend)
{
    static const char *const text[] = {
        [RL_CATALOGUE_CPU] =
            "ours: in C every row of the catalogue of hard cases is within its bound (8 ulp, or "
            "what the arguments' rounding does)",
        [RL_CATALOGUE_GPU] =
            "ours: in GLSL every row of the catalogue of hard cases is within its bound (1e-5 of "
            "the answer, 1e-6, or what the arguments' rounding does)"};
    char pattern[64];
    struct sum sum = {0};
    struct rl_claim *c = rl_judging_claim(j, text[backend]);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "rows";
    snprintf(pattern, sizeof pattern, "series=rows backend=%s", rl_hard_backend(backend));
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, pattern));) {
        double share = value(r, "worst_share");
        sum.rows += value(r, "rows");
        sum.failed += value(r, "failed");
        sum.functions++;
        if (share <= c->value)
            continue;
        rl_claim_value(c, share, share, share, "of the bound");
        rl_parameter(r->parameters, "function", sum.worst, sizeof sum.worst);
        sum.line = value(r, "line");
    }
    c->verdict = rl_verdict_at_most(c->low, c->high, 1.0);
    if (sum.functions > 0)
        snprintf(c->note, sizeof c->note,
                 "%g of %g rows of %zu functions fail; the worst row is line %g of %s.tsv", sum.failed,
                 sum.rows, sum.functions, sum.line, sum.worst);
    return RL_OK;
}

/* The figure of a map has its name; NULL: it has none. */
static const char *figure_of(const char *map)
{
    const struct rl_study *study = rl_study_find("hard");
    for (size_t i = 0; study && i < study->n_figures_alone; i++)
        if (strcmp(study->figures_alone[i].name, map) == 0)
            return study->figures_alone[i].name;
    return NULL;
}

/* One map on one backend: the case of a measured record. */
static int claim_map(const struct rl_judging *j, const struct rl_record *of)
{
    bool gpu = rl_parameters_match(of->parameters, "backend=gpu");
    char text[256], map[RL_NAME_MAX];
    rl_parameter(of->parameters, "map", map, sizeof map);
    snprintf(text, sizeof text,
             "ours: %s in %s: within %s, or what the arguments' rounding does, over its map", map,
             in_words[gpu], gpu ? "1e-5 of the answer, 1e-6" : "8 ulp");
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = figure_of(map);
    c->figure = c->figure ? c->figure : "rows";
    double share = value(of, "worst_share");
    rl_claim_value(c, share, share, share, "of the bound");
    c->verdict = rl_verdict_at_most(c->low, c->high, 1.0);
    snprintf(
        c->note, sizeof c->note,
        "%g points: worst %.3g ulp, median %.3g ulp; %g beyond the bound, %g above the plain one by what "
        "their arguments' rounding does",
        value(of, "points"), value(of, "worst_ulp"), value(of, "median_ulp"), value(of, "beyond_points"),
        value(of, "conditioned_points"));
    return RL_OK;
}

int rl_hard_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    const struct rl_judging j = {run, RL_NO_SCENE, claims, error};
    int status = RL_OK;
    for (int b = 0; b < RL_CATALOGUE_BACKENDS && status == RL_OK; b++)
        status = claim_rows(&j, (enum rl_catalogue_backend)b);
    for (const struct rl_record *r = NULL;
         status == RL_OK && (r = rl_run_next(run, r, RL_NO_SCENE, "series=map"));)
        status = claim_map(&j, r);
    return status;
}
