/* The claims that the study `budget` judges. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "studies/budget.h"
#include "studies/judging.h"

static const char *const single[] = {"sampling", "normals", "map",   "format",
                                     "parallax", "sphere",  "frame", "bits"};

enum { SINGLES = sizeof single / sizeof single[0] };

static const struct rl_metric *find(const struct rl_judging *j, const char *arm, double rr,
                                    const char *metric)
{
    char pattern[64];
    snprintf(pattern, sizeof pattern, "arm=%s rr=%g", arm, rr);
    return rl_judging_metric(j, pattern, metric);
}

/* The approximation of the largest squared error, `but` one; NULL if none was measured. */
static const char *largest(const struct rl_judging *j, double rr, const char *but)
{
    const char *name = NULL;
    double most = -1.0;
    for (int i = 0; i < SINGLES; i++) {
        const struct rl_metric *m = find(j, single[i], rr, "mse");
        if (!m || strcmp(single[i], but) == 0 || !(m->value > most))
            continue;
        most = m->value;
        name = single[i];
    }
    return name;
}

/* Whether an arm's share of the sum keeps to a bound at every R_r. */
static int claim_share(const struct rl_judging *j, const double *rr, size_t n, const char *arm,
                       const char *text, bool at_least, double bound)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "smoother";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *m = find(j, arm, rr[i], "share");
        if (!m)
            continue;
        step[i] = (struct rl_step){rr[i], m->value, m->low, m->high,
                                   at_least ? rl_verdict_at_least(m->low, m->high, bound)
                                            : rl_verdict_at_most(m->low, m->high, bound)};
    }
    rl_judging_conclude(c, step, n, "of the sum of MSE");
    return RL_OK;
}

/* After sampling: against the largest of the others, at the central R_r. */
static int claim_second(const struct rl_judging *j, double rr)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: of what more samples cannot mend, the map's single position (parallax) is the largest part "
           "(ratio of RMSE to the next)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "sources";
    const struct rl_metric *position = find(j, "parallax", rr, "rmse"), *next = NULL;
    const char *name = NULL;
    for (int i = 0; i < SINGLES; i++) {
        const struct rl_metric *m = find(j, single[i], rr, "rmse");
        if (!m || strcmp(single[i], "sampling") == 0 || strcmp(single[i], "parallax") == 0 ||
            (next && m->value <= next->value))
            continue;
        next = m;
        name = single[i];
    }
    if (!position || !next || !(next->value > 0.0))
        return RL_OK;
    rl_judging_ratio(c, position, next, "times");
    snprintf(c->note, sizeof c->note, "at R_r %g: parallax %.3g, next %s %.3g", rr, position->value, name,
             next->value);
    c->verdict = rl_verdict_at_least(c->low, c->high, 1.0);
    return RL_OK;
}

/* What dominates, whatever it is: the largest against the next. */
static int claim_dominates(const struct rl_judging *j, double rr)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: one approximation dominates: its squared error is at least twice that of any other");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "sources";
    const char *first = largest(j, rr, ""), *second = first ? largest(j, rr, first) : NULL;
    const struct rl_metric *a = first ? find(j, first, rr, "mse") : NULL;
    const struct rl_metric *b = second ? find(j, second, rr, "mse") : NULL;
    if (!a || !b || !(b->value > 0.0))
        return RL_OK;
    rl_judging_ratio(c, a, b, "times");
    snprintf(c->note, sizeof c->note, "at R_r %g: %s, MSE %.3g; next %s, %.3g", rr, first, a->value, second,
             b->value);
    c->verdict = rl_verdict_at_least(c->low, c->high, 2.0);
    return RL_OK;
}

static int claim_interaction(const struct rl_judging *j, double rr)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: the single squared errors add up to the whole: the "
                                             "interaction left over is within 10 % of it");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "sources";
    const struct rl_metric *m = find(j, "all", rr, "interaction_share"), *all = find(j, "all", rr, "rmse");
    if (!m || !all)
        return RL_OK;
    rl_claim_value(c, m->value, m->low, m->high, "of the MSE of all");
    snprintf(c->note, sizeof c->note, "at R_r %g; RMSE of all together %.3g", rr, all->value);
    c->verdict = rl_verdict_equals(m->low, m->high, 0.0, 0.1);
    return RL_OK;
}

int rl_budget_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        struct rl_judging j = {run, scene, claims, error};
        double rr[RL_AXIS_MAX];
        size_t n = rl_judging_axis(&j, "", "rr", rr);
        double central = rl_central_rr(rr, n);
        status = claim_dominates(&j, central);
        if (status == RL_OK)
            status = claim_share(
                &j, rr, n, "sampling",
                "ours: of all approximations 4 normals a pixel make most of the squared error", true, 0.5);
        if (status == RL_OK)
            status = claim_second(&j, central);
        if (status == RL_OK)
            status = claim_share(
                &j, rr, n, "normals",
                "paper: 8-bit normals make almost no difference: at most 1 % of the squared error", false,
                0.01);
        if (status == RL_OK)
            status = claim_share(
                &j, rr, n, "frame",
                "paper: the tangent frame as printed serves: at most 1 % of the squared error", false, 0.01);
        if (status == RL_OK)
            status = claim_interaction(&j, central);
    }
    return status;
}
