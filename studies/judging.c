/* See judging.h. */
#include "studies/judging.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/study.h"

struct rl_claim *rl_judging_claim(const struct rl_judging *j, const char *text)
{
    struct rl_claim *c = rl_claims_add(j->claims, j->error);
    if (!c)
        return NULL;
    snprintf(c->text, sizeof c->text, "%.200s (%.40s)", text, j->scene);
    rl_claim_source(c, j->run, j->scene);
    return c;
}

const struct rl_metric *rl_judging_metric(const struct rl_judging *j, const char *pattern, const char *metric)
{
    const struct rl_record *r = rl_run_find(j->run, j->scene, pattern);
    return r ? rl_record_metric(r, metric) : NULL;
}

size_t rl_judging_axis(const struct rl_judging *j, const char *pattern, const char *key,
                       double value[RL_AXIS_MAX])
{
    size_t n = 0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, pattern));) {
        double x = rl_parameter_number(r->parameters, key);
        size_t at = 0;
        while (at < n && value[at] < x)
            at++;
        if (isnan(x) || (at < n && value[at] == x) || n == RL_AXIS_MAX)
            continue;
        memmove(value + at + 1, value + at, (n - at) * sizeof *value);
        value[at] = x;
        n++;
    }
    return n;
}

double rl_central_rr(const double *rr, size_t n)
{
    double best = n ? rr[0] : RL_CENTRAL_RR;
    for (size_t i = 1; i < n; i++)
        if (fabs(log(rr[i] / RL_CENTRAL_RR)) < fabs(log(best / RL_CENTRAL_RR)))
            best = rr[i];
    return best;
}

void rl_judging_along(struct rl_claim *c, const double *rr, const enum rl_verdict *verdict, size_t n)
{
    size_t smooth = 0, rough = 0, failing = 0;
    while (smooth < n && verdict[n - 1 - smooth] == RL_VERDICT_HOLDS)
        smooth++;
    while (rough < n && verdict[rough] == RL_VERDICT_HOLDS)
        rough++;
    for (size_t i = 0; i < n; i++)
        failing += verdict[i] == RL_VERDICT_FAILS;
    if (n > 0 && smooth == n) {
        c->verdict = RL_VERDICT_HOLDS;
    } else if (smooth + rough > 0 && failing > 0) {
        c->verdict = RL_VERDICT_HOLDS_UP_TO;
        if (smooth >= rough)
            rl_claim_value(c, rr[n - smooth], rr[n - smooth - 1], rr[n - smooth], "R_r and smoother");
        else
            rl_claim_value(c, rr[rough - 1], rr[rough - 1], rr[rough], "R_r and rougher");
    } else if (n > 0 && failing == n) {
        c->verdict = RL_VERDICT_FAILS;
    }
}

void rl_judging_note(struct rl_claim *c, double rr, double value)
{
    size_t used = strlen(c->note);
    if (isinf(value))
        snprintf(c->note + used, sizeof c->note - used, "%sR_r %g: none", used ? "; " : "", rr);
    else
        snprintf(c->note + used, sizeof c->note - used, "%sR_r %g: %.3g", used ? "; " : "", rr, value);
}

void rl_judging_ratio(struct rl_claim *c, const struct rl_metric *a, const struct rl_metric *b,
                      const char *unit)
{
    rl_claim_value(c, a->value / b->value, a->low / b->high, b->low > 0.0 ? a->high / b->low : INFINITY,
                   unit);
}
