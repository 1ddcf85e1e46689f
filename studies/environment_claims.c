/* The claims that the study `environment` judges. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "measure/statistics.h"
#include "studies/environment.h"
#include "studies/judging.h"

/* No texel is larger than those in the middle of a face, but a light's edge may run along the texels in one place and across them in
 * another. A face that is missing, turned or mirrored would be wrong by far more. */
static const double seam_bound = 1.25;

/* A figure of one case against one step of an 8-bit frame buffer. Where the format alone differs, an error of 0 is the format's. */
static int claim_step(const struct rl_judging *j, const char *figure, const char *pattern, const char *metric,
                      const char *text, const char *note)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = figure;
    const struct rl_metric *m = rl_judging_metric(j, pattern, metric);
    if (!m)
        return RL_OK;
    if (!rl_judging_lit(rl_judging_metric(j, pattern, "highlight"))) {
        snprintf(c->note, sizeof c->note, "%s", rl_judging_dark);
        return RL_OK;
    }
    bool exact = m->high == 0.0 && strcmp(figure, "format") == 0;
    rl_claim_value(c, m->value, m->low, m->high, "RMSE");
    snprintf(c->note, sizeof c->note, "%s%s%s", note, exact ? "; " : "", exact ? rl_judging_exactly : "");
    c->verdict = rl_verdict_at_most(m->low, m->high, RL_STEP_OF_8_BITS);
    return RL_OK;
}

/* Against the reference: the largest map stands for the truth above, and shares with the others what is wrong in all. */
static int claim_floors(const struct rl_judging *j)
{
    double base[RL_AXIS_MAX];
    char pattern[64];
    size_t n = rl_judging_axis(j, "series=size base=1", "env_size", base);
    snprintf(pattern, sizeof pattern, "series=size base=1 env_size=%g", n ? base[0] : 0.0);
    int status = claim_step(
        j, "size", "series=size base=0 env_size=256", "floor_centre",
        "ours: what a map of 256 texels shows is true: its floor against the reference is at most 1/255",
        "lights seen from the object's centre, noise taken out");
    return status == RL_OK ? claim_step(j, "size", pattern, "floor_centre",
                                        "ours: what the largest map shows is true: its floor against the "
                                        "reference is at most 1/255",
                                        "lights seen from the object's centre, noise taken out")
                           : status;
}

/* The pairs (x, y) of measured rows that have both metrics or parameters; at most RL_AXIS_MAX. */
static size_t points(const struct rl_judging *j, const char *pattern, const char *key, const char *metric,
                     double x[RL_AXIS_MAX], double y[RL_AXIS_MAX])
{
    size_t n = 0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, pattern));) {
        const struct rl_metric *m = rl_record_metric(r, metric), *k = rl_record_metric(r, key);
        if (!m || n == RL_AXIS_MAX)
            continue;
        x[n] = k ? k->value : rl_parameter_number(r->parameters, key);
        y[n++] = m->value;
    }
    return n;
}

/* The same from the largest x to the smallest, in whatever order an axis has them. */
static size_t falling_points(const struct rl_judging *j, const char *pattern, const char *key,
                             const char *metric, double x[RL_AXIS_MAX], double y[RL_AXIS_MAX])
{
    size_t n = points(j, pattern, key, metric, x, y);
    for (size_t i = 1; i < n; i++)
        for (size_t k = i; k > 0 && x[k] > x[k - 1]; k--) {
            double a = x[k], b = y[k];
            x[k] = x[k - 1], y[k] = y[k - 1];
            x[k - 1] = a, y[k - 1] = b;
        }
    return n;
}

/* The points of a fit. An error that noise hides came out as 0, which has no logarithm: it is known to be at most its interval's end,
 * and leaving it out would keep the large errors alone. */
struct slope_points {
    size_t n, n_all;                             /* those above 0; with those hidden, which come last */
    double size[RL_AXIS_MAX], rmse[RL_AXIS_MAX]; /* of one that is hidden, the most that it may be */
    char hidden[160], exact[160];                /* in words: what was not above 0 */
};

/* Adds "256 (at most 0.001)", or the texels alone where there is no more to say. */
static void note_point(char text[160], double texels, double most)
{
    size_t used = strlen(text);
    char also[32] = "";
    if (most > 0.0)
        snprintf(also, sizeof also, " (at most %.2g)", most);
    snprintf(text + used, 160 - used, "%s%g%s", used ? ", " : "", texels, also);
}

static void slope_points(struct slope_points *p, const struct rl_judging *j, double largest)
{
    *p = (struct slope_points){0};
    for (int hidden = 0; hidden < 2; hidden++) {
        for (const struct rl_record *r = NULL;
             (r = rl_run_next(j->run, r, j->scene, "series=size base=0")) && p->n_all < RL_AXIS_MAX;) {
            const struct rl_metric *m = rl_record_metric(r, "floor_map");
            double size = rl_parameter_number(r->parameters, "env_size");
            if (!m || !(size <= largest) || (m->value > 0.0) == (hidden == 1))
                continue;
            if (hidden && !(m->high > 0.0)) {
                note_point(p->exact, size, 0.0);
                continue;
            }
            if (hidden)
                note_point(p->hidden, size, m->high);
            p->size[p->n_all] = size;
            p->rmse[p->n_all++] = hidden ? m->high : m->value;
        }
        p->n = hidden ? p->n : p->n_all;
    }
}

/* An edge of the light is wrong by half a texel at most: less than in proportion would be a fault. The largest maps are near the one
 * that stands for the truth and look too good: only up to a quarter of it. The interval holds the fits with and without what
 * noise hides. */
static int claim_slope(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: the map's error falls at least in proportion to its texels' size (slope at most -1)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "size";
    double base[RL_AXIS_MAX];
    size_t n_base = rl_judging_axis(j, "series=size base=1", "env_size", base);
    struct slope_points p;
    slope_points(&p, j, n_base > 0 ? base[0] / 4.0 : 0.0);
    struct rl_interval s = rl_loglog_slope(p.size, p.rmse, p.n, 0.95);
    if (p.n_all > p.n) {
        struct rl_interval most = rl_loglog_slope(p.size, p.rmse, p.n_all, 0.95);
        s = (struct rl_interval){isnan(s.value) ? most.value : s.value, fmin(s.low, most.low),
                                 fmax(s.high, most.high)};
    }
    rl_claim_value(c, s.value, s.low, s.high, "slope");
    if (*p.hidden || *p.exact)
        snprintf(c->note, sizeof c->note, "%s%s%s%s%s", *p.hidden ? "hidden by noise at texels " : "",
                 p.hidden, *p.hidden && *p.exact ? "; " : "",
                 *p.exact ? "left out, no error at all, texels " : "", p.exact);
    c->verdict = rl_verdict_at_most(s.low, s.high, -1.0);
    return RL_OK;
}

/* The scene's own size, and how small the object would have to be: in proportion from the two measured sizes around it, or from
 * the smallest one. */
static int claim_parallax(const struct rl_judging *j)
{
    int status =
        claim_step(j, "parallax", "series=parallax away=1", "parallax",
                   "paper: one map for a whole object serves: its parallax is at most 1/255 here", "");
    struct rl_claim *c = status == RL_OK ? &j->claims->claim[j->claims->n - 1] : NULL;
    if (!c || isnan(c->value))
        return status;
    double size[RL_AXIS_MAX], rmse[RL_AXIS_MAX];
    size_t n = falling_points(j, "series=parallax", "size", "parallax", size, rmse), below = 0;
    while (below < n && rmse[below] > RL_STEP_OF_8_BITS)
        below++;
    const struct rl_metric *own = rl_judging_metric(j, "series=parallax away=1", "size");
    double here = own ? own->value : NAN;
    if (n > 0 && below == n)
        snprintf(c->note, sizeof c->note,
                 "object's radius over the light's distance %.3g; the smallest measured, %.3g: %.3g", here,
                 size[n - 1], rmse[n - 1]);
    else if (below > 0) {
        double t = log(rmse[below - 1] / RL_STEP_OF_8_BITS) / log(rmse[below - 1] / rmse[below]);
        snprintf(c->note, sizeof c->note,
                 "object's radius over the light's distance %.3g; 1/255 is reached at %.3g", here,
                 size[below - 1] * pow(size[below] / size[below - 1], t));
    }
    return RL_OK;
}

static int claim_parallax_slope(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: parallax grows in proportion to the object's size over the light's distance (slope 1 to "
           "within 0.15)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "parallax";
    double size[RL_AXIS_MAX], rmse[RL_AXIS_MAX];
    size_t n = falling_points(j, "series=parallax", "size", "parallax", size, rmse);
    struct rl_interval s = rl_loglog_slope(size, rmse, n, 0.95);
    rl_claim_value(c, s.value, s.low, s.high, "slope");
    if (n >= 2)
        snprintf(c->note, sizeof c->note, "between the two smallest sizes %.3g",
                 log(rmse[n - 2] / rmse[n - 1]) / log(size[n - 2] / size[n - 1]));
    c->verdict = rl_verdict_equals(s.low, s.high, 1.0, 0.15);
    return RL_OK;
}

/* The worse of edge and corner against the middle, at the smallest map: its texels are largest. */
static int claim_seam(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: seams do no harm: across an edge or corner of the cube "
                                             "the error is at most 1.25 times that in a face's middle");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "seam";
    double size[RL_AXIS_MAX];
    size_t n = rl_judging_axis(j, "series=seam base=0", "env_size", size);
    static const char *const place[] = {"middle", "edge", "corner"};
    const struct rl_metric *m[3] = {NULL};
    for (int i = 0; i < 3 && n > 0; i++) {
        char pattern[96];
        snprintf(pattern, sizeof pattern, "series=seam base=0 place=%s env_size=%g", place[i], size[0]);
        m[i] = rl_judging_metric(j, pattern, "floor_map");
    }
    if (!m[0] || !m[1] || !m[2])
        return RL_OK;
    rl_judging_ratio(c, m[1]->value > m[2]->value ? m[1] : m[2], m[0], "times");
    snprintf(c->note, sizeof c->note, "%g texels a face edge; RMSE: middle %.3g, edge %.3g, corner %.3g",
             size[0], m[0]->value, m[1]->value, m[2]->value);
    c->verdict = rl_verdict_at_most(c->low, c->high, seam_bound);
    return RL_OK;
}

int rl_environment_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        struct rl_judging j = {run, scene, claims, error};
        status = claim_step(&j, "size", "series=size base=0 env_size=256", "rmse_map",
                            "paper: 256 texels a face edge are enough: their error is at most 1/255",
                            "against the largest map, same seeds, float normals");
        if (status == RL_OK)
            status = claim_step(&j, "format", "series=format env_format=rgba8", "rmse_map",
                                "paper: texels of 8 bits are enough: their error is at most 1/255",
                                "against 32-bit floats, same seeds");
        int (*const claim[])(const struct rl_judging *) = {claim_floors, claim_slope, claim_parallax,
                                                           claim_parallax_slope, claim_seam};
        for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
            status = claim[k](&j);
    }
    return status;
}
