/* The claims that the study `margin` judges. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "studies/judging.h"
#include "studies/margin.h"
#include "studies/timing_arms.h"

static const double enough_energy = 0.01, cheap_pass = 0.1;

/* What lights made for a bound lose of it, at least, where the margin is hardly larger than it must be: 0.47 to 0.62 where they can be
 * large (margin.h). And how near it is to what the proof leaves them, which is known to many digits. */
static const double filled_least = 0.4, due_slack = 0.01;

static const struct rl_metric *find(const struct rl_judging *j, const char *arm, double rr,
                                    const char *metric)
{
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=margin arm=%s rr=%g", arm, rr);
    return rl_judging_metric(j, pattern, metric);
}

/* Two arms of the same work. */
static double noise_floor(const struct rl_judging *j, double rr)
{
    return rl_arms_noise(find(j, "again", rr, "time_to_off"));
}

/* At every R_r where auto has a sphere; the worst pixel speaks. */
static int claim_bound(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: margin auto keeps its bound: no pixel loses more than 2 % of the light's radiance");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "bound";
    double most = NAN;
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *spheres = find(j, "auto", rr[i], "spheres");
        const struct rl_metric *worst = find(j, "auto", rr[i], "worst_exact");
        const struct rl_metric *bound = find(j, "auto", rr[i], "bound");
        if (!spheres || !worst || !bound || !(spheres->value > 0.0))
            continue;
        rl_judging_note(c, rr[i], worst->value);
        if (rl_judging_worse(c, rl_verdict_at_most(worst->low, worst->high, bound->value), worst->value,
                             &most))
            rl_claim_value(c, worst->value, worst->low, worst->high, "of the radiance");
    }
    return RL_OK;
}

/* Every other bound that was asked for, in units of itself. */
static int claim_any_bound(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: the closed form keeps any bound that is asked for: worst pixel over bound, at most 1");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "bound";
    double most = NAN;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "series=bound"));) {
        const struct rl_metric *worst = rl_record_metric(r, "worst_exact");
        const struct rl_metric *bound = rl_record_metric(r, "bound");
        const struct rl_metric *spheres = rl_record_metric(r, "spheres");
        if (!worst || !bound || !spheres || !(spheres->value > 0.0))
            continue;
        if (!rl_judging_worse(c, rl_verdict_at_most(worst->low, worst->high, bound->value),
                              worst->value / bound->value, &most))
            continue;
        rl_claim_value(c, worst->value / bound->value, worst->low / bound->value, worst->high / bound->value,
                       "of the bound");
        snprintf(c->note, sizeof c->note, "nearest to its bound: %g at R_r %g", bound->value,
                 rl_parameter_number(r->parameters, "rr"));
    }
    return RL_OK;
}

/* The proof bounds what a pixel loses, and so the energy of all pixels skipped; not its share of a highlight, which may be all tail. */
static int claim_loss(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: the energy missed is at most bound x radiance x pixels "
                                             "skipped: mean loss over bound, at most 1");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "mean";
    double most = NAN;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, ""));) {
        const struct rl_metric *loss = rl_record_metric(r, "loss_exact");
        const struct rl_metric *bound = rl_record_metric(r, "bound");
        const struct rl_metric *spheres = rl_record_metric(r, "spheres");
        if (!loss || !bound || !spheres || !(spheres->value > 0.0) ||
            !rl_judging_worse(c, rl_verdict_at_most(loss->low, loss->high, bound->value),
                              loss->value / bound->value, &most))
            continue;
        rl_claim_value(c, loss->value / bound->value, loss->low / bound->value, loss->high / bound->value,
                       "of the bound");
        snprintf(c->note, sizeof c->note, "nearest to its bound: %g at R_r %g", bound->value,
                 rl_parameter_number(r->parameters, "rr"));
    }
    return RL_OK;
}

/* What lights made for a bound lose of it, row by row. What a scene's own lights lose may be far below the bound: these claims need
 * no scene. */
struct filled_row {
    double value;
    enum rl_verdict verdict;
    double badness;
};

/* The promise. */
static struct filled_row keeps(struct rl_margin_filled f)
{
    return (struct filled_row){f.lost, rl_verdict_at_most(f.lost, f.lost, 1.0), f.lost};
}

/* As large as the proof asks: smaller breaks it, larger wastes time. Without a sphere where there could be one, nothing is lost. */
static struct filled_row as_proved(struct rl_margin_filled f)
{
    double ratio = f.lost / f.due;
    return (struct filled_row){ratio, rl_verdict_equals(ratio, ratio, 1.0, due_slack), fabs(ratio - 1.0)};
}

/* What the proof gives away. */
static struct filled_row tight(struct rl_margin_filled f)
{
    return (struct filled_row){f.lost, rl_verdict_at_least(f.lost, f.lost, filled_least), -f.lost};
}

/* Every row is judged, and the worst speaks. */
static int claim_filled(const struct rl_judging *j, const char *text, const char *unit,
                        struct filled_row (*judge)(struct rl_margin_filled))
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "filled";
    double most = NAN, bound = NAN, rr = NAN;
    size_t n = 0, outside = 0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "series=filled"));) {
        const struct rl_metric *filled = rl_record_metric(r, "filled"), *due = rl_record_metric(r, "due");
        if (!filled || !due)
            continue;
        struct filled_row row = judge((struct rl_margin_filled){filled->value, due->value});
        n++;
        outside += row.verdict != RL_VERDICT_HOLDS;
        if (!rl_judging_worse(c, row.verdict, row.badness, &most))
            continue;
        rl_claim_value(c, row.value, row.value, row.value, unit);
        bound = rl_parameter_number(r->parameters, "loss");
        rr = rl_parameter_number(r->parameters, "rr");
    }
    if (n > 0)
        snprintf(c->note, sizeof c->note,
                 "two equal lights on opposite sides; the worst of %zu rows: bound %g at R_r %g; %zu outside",
                 n, bound, rr, outside);
    return RL_OK;
}

static int judge_alone(const struct rl_judging *j)
{
    int status = claim_filled(j,
                              "ours: the closed form keeps its bound whatever the lights: two made for it "
                              "lose at most all of it",
                              "of the bound", keeps);
    if (status == RL_OK)
        status =
            claim_filled(j,
                         "ours: the closed form is as large as its proof asks, neither smaller nor larger: "
                         "lights made for it lose what that leaves them, within 1 %",
                         "of what is left", as_proved);
    return status == RL_OK
               ? claim_filled(j,
                              "ours: the closed form is hardly larger than any light needs: lights made "
                              "for it lose at least 0.4 of its bound",
                              "of the bound", tight)
               : status;
}

/* Whether the share of energy that an arm misses is small enough, along the R_r where it has a sphere; where it is at all of them, the
 * largest share speaks. Of the integral: frames agree
 * with it, but for noise. */
static int claim_energy(const struct rl_judging *j, const double *rr, size_t n, const char *arm,
                        const char *text, double bound)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "missed";
    struct rl_step step[RL_AXIS_MAX];
    size_t n_judged = 0;
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *m = find(j, arm, rr[i], "missed_exact");
        const struct rl_metric *spheres = find(j, arm, rr[i], "spheres");
        if (!spheres || !(spheres->value > 0.0))
            continue;
        rl_judging_steps(&step[n_judged], &rr[i], 1);
        if (m)
            step[n_judged] = (struct rl_step){rr[i], m->value, m->low, m->high,
                                              rl_verdict_at_most(m->low, m->high, bound)};
        n_judged++;
    }
    const struct rl_step *most = n_judged > 0 ? &step[0] : NULL;
    bool all = n_judged > 0;
    for (size_t i = 0; i < n_judged; i++) {
        all = all && step[i].verdict == RL_VERDICT_HOLDS;
        most = step[i].value > most->value ? &step[i] : most;
    }
    if (all) {
        rl_claim_value(c, most->value, most->low, most->high, "of the highlight");
        snprintf(c->note, sizeof c->note, "the most, at R_r %g", most->rr);
    }
    rl_judging_conclude(c, step, n_judged, "of the highlight");
    return RL_OK;
}

/* Of the R_r where auto has a sphere: where it has none, nothing is drawn that could save time, and the note names them. Not every R_r is
 * timed. Intervals have the noise of two equal arms in them, as what was judged. */
static int claim_time(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(j, "paper: the sphere saves time; here with margin auto where that has one, frame "
                            "time over that without the pass, below 1, noise included");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "trade";
    struct rl_step step[RL_AXIS_MAX];
    size_t n_judged = 0, used = 0;
    const struct rl_metric *from = NULL;
    char without[96] = "";
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *times = find(j, "auto", rr[i], "time_to_off");
        const struct rl_metric *spheres = find(j, "auto", rr[i], "spheres");
        from = from ? from : find(j, "auto", rr[i], "from_rr");
        if (spheres && spheres->value == 0.0 && used < sizeof without)
            used += (size_t)snprintf(without + used, sizeof without - used, "%s%g", used ? ", " : "", rr[i]);
        if (!spheres || !times || !(spheres->value > 0.0))
            continue;
        double noise = noise_floor(j, rr[i]);
        step[n_judged++] = (struct rl_step){rr[i], times->value, times->low - noise, times->high + noise,
                                            rl_arms_at_most(times, noise, 1.0)};
    }
    rl_judging_conclude(c, step, n_judged, "times");
    size_t noted = strlen(c->note);
    if (from)
        snprintf(c->note + noted, sizeof c->note - noted, "%s%s%s%s%s from R_r %.3g on", noted ? "; " : "",
                 used ? "no sphere at R_r " : "", without, used ? ": " : "",
                 used ? "auto has one" : "auto has a sphere", from->value);
    return RL_OK;
}

/* The pass alone: a margin that lets every pixel through. The R_r where it costs most speaks for all. */
static int claim_cost(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: the sphere pass itself is cheap: where it saves nothing it adds at most 10 % to the frame "
           "(noise included)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "cost";
    double most = NAN;
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *times = find(j, "huge", rr[i], "time_to_off");
        if (!times)
            continue;
        rl_judging_note(c, rr[i], times->value - 1.0);
        double noise = noise_floor(j, rr[i]);
        if (rl_judging_worse(c, rl_arms_at_most(times, noise, 1.0 + cheap_pass), times->value, &most))
            rl_claim_value(c, times->value - 1.0, times->low - noise - 1.0, times->high + noise - 1.0,
                           "of a frame");
    }
    return RL_OK;
}

static int judge_scene(const struct rl_judging *j)
{
    double rr[RL_AXIS_MAX];
    size_t n = rl_judging_axis(j, "series=margin", "rr", rr);
    int status = claim_bound(j, rr, n);
    if (status == RL_OK)
        status = claim_any_bound(j);
    if (status == RL_OK)
        status = claim_loss(j);
    if (status == RL_OK)
        status =
            claim_energy(j, rr, n, "auto", "ours: margin auto misses at most 1 % of the highlight's energy",
                         enough_energy);
    if (status == RL_OK)
        status =
            claim_energy(j, rr, n, "0.5",
                         "paper: a sphere somewhat larger than the light suffices: 1.5 times as large it "
                         "misses at most 1 % of the energy",
                         enough_energy);
    if (status == RL_OK)
        status = claim_time(j, rr, n);
    return status == RL_OK ? claim_cost(j, rr, n) : status;
}

int rl_margin_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        const struct rl_judging j = {run, scene, claims, error};
        status = strcmp(scene, RL_NO_SCENE) == 0 ? judge_alone(&j) : judge_scene(&j);
    }
    return status;
}
