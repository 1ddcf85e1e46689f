/* See judging.h. */
#include "studies/judging.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/study.h"

const char rl_judging_exactly[] = "not one pixel changes: the format holds this scene's radiances exactly";
const char rl_judging_dark[] = "not judged, for no normal met a light";

struct rl_claim *rl_judging_claim(const struct rl_judging *j, const char *text)
{
    struct rl_claim *c = rl_claims_add(j->claims, j->error);
    if (!c)
        return NULL;
    if (strcmp(j->scene, RL_NO_SCENE) == 0)
        snprintf(c->text, sizeof c->text, "%.250s", text);
    else
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

void rl_judging_steps(struct rl_step step[RL_AXIS_MAX], const double *rr, size_t n)
{
    for (size_t i = 0; i < n; i++)
        step[i] = (struct rl_step){rr[i], NAN, NAN, NAN, RL_VERDICT_INCONCLUSIVE};
}

/* Of the measured steps of that verdict the nearest to the central R_r; NULL if there is none. */
static const struct rl_step *speaker(const struct rl_step *step, size_t n, enum rl_verdict verdict)
{
    const struct rl_step *best = NULL;
    for (size_t i = 0; i < n; i++)
        if (step[i].verdict == verdict && !isnan(step[i].value) &&
            (!best || fabs(log(step[i].rr / RL_CENTRAL_RR)) < fabs(log(best->rr / RL_CENTRAL_RR))))
            best = &step[i];
    return best;
}

static void note_all(struct rl_claim *c, const struct rl_step *step, size_t n)
{
    size_t measured = 0;
    for (size_t i = 0; i < n; i++)
        measured += !isnan(step[i].value);
    for (size_t i = 0; i < n && measured > 0; i++)
        rl_judging_note(c, step[i].rr, step[i].value);
}

/* The verdict of all is that of the step that speaks for them, whose number is shown but where the claim has one already. */
static void speak(struct rl_claim *c, const struct rl_step *step, size_t n, enum rl_verdict verdict,
                  const char *unit)
{
    const struct rl_step *s = speaker(step, n, verdict);
    c->verdict = verdict;
    if (s && (verdict != RL_VERDICT_HOLDS || isnan(c->value))) {
        size_t used = strlen(c->note);
        rl_claim_value(c, s->value, s->low, s->high, unit);
        snprintf(c->note + used, sizeof c->note - used, "%sat R_r %g", used ? "; " : "", s->rr);
    } else if (!s) {
        rl_claim_value(c, NAN, NAN, NAN, unit);
    }
}

/* "fails: 2 [1.9, 2.1] of what is allowed"; an infinite value is of something that was looked for and is not there. */
static void step_text(char text[160], const struct rl_step *s, const char *unit)
{
    const char *verdict = s->verdict == RL_VERDICT_FAILS ? "fails" : "is undecided";
    const char *of = strcmp(unit, "1") == 0 ? "" : unit, *blank = *of ? " " : "";
    if (isnan(s->value))
        snprintf(text, 160, "was not measured");
    else if (isfinite(s->value) && s->low == s->high)
        snprintf(text, 160, "%s: %.3g%s%s", verdict, s->value, blank, of);
    else if (isfinite(s->value))
        snprintf(text, 160, "%s: %.3g [%.3g, %.3g]%s%s", verdict, s->value, s->low, s->high, blank, of);
    else if (isfinite(s->low))
        snprintf(text, 160, "%s: none, or %.3g%s%s", verdict, s->low, blank, of);
    else
        snprintf(text, 160, "%s: none", verdict);
}

/* What ended the reach, in the figure's own unit, which the claim's number does not have; and how far the other end reaches (0: not). */
static void note_reach(struct rl_claim *c, const struct rl_step *next, double other, const char *unit)
{
    char text[160], also[64] = "";
    size_t used = strlen(c->note);
    step_text(text, next, unit);
    if (other > 0.0)
        snprintf(also, sizeof also, "; also at R_r %g and %s", other,
                 c->value > next->rr ? "rougher" : "smoother");
    snprintf(c->note + used, sizeof c->note - used, "%snext, R_r %g, %s%s", used ? "; " : "", next->rr, text,
             also);
}

static void reach(struct rl_claim *c, const struct rl_step *step, size_t n, size_t rough, size_t smooth,
                  const char *unit)
{
    c->verdict = RL_VERDICT_HOLDS_UP_TO;
    if (smooth >= rough) {
        size_t end = n - smooth, failing = end;
        while (failing > 0 && step[failing - 1].verdict != RL_VERDICT_FAILS)
            failing--;
        rl_claim_value(c, step[end].rr, failing > 0 ? step[failing - 1].rr : 0.0, step[end].rr,
                       "R_r and smoother");
        note_reach(c, &step[end - 1], rough > 0 ? step[rough - 1].rr : 0.0, unit);
    } else {
        size_t failing = rough;
        while (failing < n && step[failing].verdict != RL_VERDICT_FAILS)
            failing++;
        rl_claim_value(c, step[rough - 1].rr, step[rough - 1].rr, failing < n ? step[failing].rr : INFINITY,
                       "R_r and rougher");
        note_reach(c, &step[rough], smooth > 0 ? step[n - smooth].rr : 0.0, unit);
    }
}

void rl_judging_conclude(struct rl_claim *c, const struct rl_step *step, size_t n, const char *unit)
{
    size_t smooth = 0, rough = 0, failing = 0;
    while (smooth < n && step[n - 1 - smooth].verdict == RL_VERDICT_HOLDS)
        smooth++;
    while (rough < n && step[rough].verdict == RL_VERDICT_HOLDS)
        rough++;
    for (size_t i = 0; i < n; i++)
        failing += step[i].verdict == RL_VERDICT_FAILS;
    if (n > 0 && smooth == n)
        speak(c, step, n, RL_VERDICT_HOLDS, unit);
    else if (smooth + rough > 0)
        reach(c, step, n, rough, smooth, unit);
    else
        speak(c, step, n, failing > 0 ? RL_VERDICT_FAILS : RL_VERDICT_INCONCLUSIVE, unit);
    note_all(c, step, n);
}

void rl_judging_instead(struct rl_step *step, const struct rl_metric *m)
{
    step->value = m ? m->value : NAN;
    step->low = m ? m->low : NAN;
    step->high = m ? m->high : NAN;
}

void rl_judging_conclude_again(struct rl_claim *c, const struct rl_step *step, size_t n, const char *unit)
{
    c->note[0] = '\0';
    rl_claim_value(c, NAN, NAN, NAN, "");
    rl_judging_conclude(c, step, n, unit);
}

bool rl_judging_worse(struct rl_claim *c, enum rl_verdict verdict, double badness, double *worst)
{
    static const int weight[] = {[RL_VERDICT_HOLDS] = 0,
                                 [RL_VERDICT_HOLDS_UP_TO] = 0,
                                 [RL_VERDICT_INCONCLUSIVE] = 1,
                                 [RL_VERDICT_FAILS] = 2};
    int more = weight[verdict] - weight[c->verdict];
    if (isnan(badness) || (!isnan(*worst) && (more < 0 || (more == 0 && badness <= *worst))))
        return false;
    c->verdict = verdict;
    *worst = badness;
    return true;
}

bool rl_judging_lit(const struct rl_metric *light)
{
    return !light || light->value > 0.0 || isnan(light->value);
}

void rl_judging_note(struct rl_claim *c, double rr, double value)
{
    size_t used = strlen(c->note);
    if (!isfinite(value))
        snprintf(c->note + used, sizeof c->note - used, "%sR_r %g: %s", used ? "; " : "", rr,
                 isnan(value) ? "not measured" : "none");
    else
        snprintf(c->note + used, sizeof c->note - used, "%sR_r %g: %.3g", used ? "; " : "", rr, value);
}

void rl_judging_ratio(struct rl_claim *c, const struct rl_metric *a, const struct rl_metric *b,
                      const char *unit)
{
    if (!(b->value > 0.0)) {
        rl_claim_value(c, NAN, NAN, NAN, unit);
        return;
    }
    rl_claim_value(c, a->value / b->value, a->low / b->high, b->low > 0.0 ? a->high / b->low : INFINITY,
                   unit);
}
