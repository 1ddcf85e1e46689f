/* What the study `fur` says of costs: vertices against pixels, the listing against its correction, colours against shades of grey. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "measure/statistics.h"
#include "studies/fur.h"
#include "studies/timing_arms.h"

/* Where figures are taken: on the study's ball at one tessellation, on a scene (0) as its meshes are. */
struct place {
    const struct rl_judging *j;
    int tessellation;
    const char *figure; /* that shows its times */
};

static struct rl_claim *begin(const struct place *p, const char *figure, const char *text, const char *mesh)
{
    char all[256];
    snprintf(all, sizeof all, "%s%s", text, p->tessellation > 0 ? mesh : ")");
    struct rl_claim *c = rl_judging_claim(p->j, all);
    if (c)
        c->figure = figure;
    return c;
}

static void note(struct rl_claim *c, const char *what, double value)
{
    size_t used = strlen(c->note);
    if (!isnan(value))
        snprintf(c->note + used, sizeof c->note - used, "%s%s: %.3g", used ? "; " : "", what, value);
}

/* ---- Rows ---- */

static const struct rl_record *find(const struct place *p, const char *pattern)
{
    char all[256];
    snprintf(all, sizeof all, "%s", pattern);
    if (p->tessellation > 0)
        snprintf(all, sizeof all, "%s tessellation=%d", pattern, p->tessellation);
    return rl_run_find(p->j->run, p->j->scene, all);
}

static const struct rl_record *arm(const struct place *p, const char *effect, const char *interpolation,
                                   const char *monochrome, const char *name)
{
    char pattern[160];
    snprintf(pattern, sizeof pattern, "series=time effect=%s interpolation=%s monochrome=%s arm=%s", effect,
             interpolation, monochrome, name);
    return find(p, pattern);
}

static const struct rl_metric *metric_of(const struct rl_record *r, const char *name)
{
    return r ? rl_record_metric(r, name) : NULL;
}

static double noise_of(const struct place *p)
{
    return rl_arms_noise(metric_of(arm(p, "kajiya", "phong", "off", "again"), "time_to_pixel"));
}

/* Two arms' frames, round by round; false: not measured. */
static bool ratio_of(struct rl_metric *m, const struct rl_record *a, const struct rl_record *b)
{
    const struct rl_series *x = a ? rl_record_series(a, "frame_ms") : NULL;
    const struct rl_series *y = b ? rl_record_series(b, "frame_ms") : NULL;
    if (!x || !y || x->n != y->n)
        return false;
    struct rl_interval r = rl_interval_from_0(rl_ratio_interval(x->value, y->value, x->n, 0.95));
    *m = (struct rl_metric){.value = r.value, .low = r.low, .high = r.high};
    return true;
}

/* ---- Times ---- */

/* Takes one more ratio into a claim that holds for all; the worst is shown, all are noted. */
static void take_ratio(struct rl_claim *c, const char *effect, const struct rl_metric *m, double noise,
                       double bound, double *worst)
{
    if (!m || isnan(noise))
        return;
    if (isnan(*worst))
        c->verdict = RL_VERDICT_HOLDS;
    if (rl_judging_worse(c, rl_arms_at_most(m, noise, bound), m->high, worst))
        rl_claim_value(c, m->value, m->low, m->high, "times");
    note(c, effect, m->value);
}

static int claim_vertices(const struct place *p, const char *mesh)
{
    double worst = NAN;
    struct rl_claim *c =
        begin(p, p->figure,
              "ours: a frame of fur takes no longer at the vertices than at each pixel (every "
              "model; time over that per pixel",
              mesh);
    if (!c)
        return RL_ERR_SYSTEM;
    double noise = noise_of(p);
    for (const char *const *e = rl_fur_models; *e; e++)
        take_ratio(c, *e, metric_of(arm(p, *e, "gouraud", "off", "frame"), "time_to_pixel"), noise, 1.0,
                   &worst);
    note(c, "A/A", noise);
    return RL_OK;
}

static int claim_against_phong(const struct place *p, const char *mesh)
{
    double worst = NAN;
    struct rl_claim *c = begin(p, p->figure,
                               "ours: fur at each pixel takes at most 5 % longer than Lambert's and Phong's "
                               "surface (every model; time of a frame over that one's",
                               mesh);
    if (!c)
        return RL_ERR_SYSTEM;
    double noise = noise_of(p);
    const struct rl_record *phong = arm(p, "phong", "phong", "off", "frame");
    for (const char *const *e = rl_fur_models; *e; e++) {
        struct rl_metric m;
        if (ratio_of(&m, arm(p, *e, "phong", "off", "frame"), phong))
            take_ratio(c, *e, &m, noise, 1.05, &worst);
    }
    note(c, "A/A", noise);
    return RL_OK;
}

static int claim_correcting(const struct place *p, const char *mesh)
{
    static const char *const pair[][2] = {{"kajiya", "kajiya-printed"}, {"goldman", "goldman-printed"}};
    double worst = NAN;
    struct rl_claim *c =
        begin(p, p->figure,
              "ours: to correct the listing takes at most 5 % more time (both models; time of "
              "a frame over that as listed",
              mesh);
    if (!c)
        return RL_ERR_SYSTEM;
    double noise = noise_of(p);
    for (size_t k = 0; k < 2; k++) {
        struct rl_metric m;
        if (ratio_of(&m, arm(p, pair[k][0], "phong", "off", "frame"),
                     arm(p, pair[k][1], "phong", "off", "frame")))
            take_ratio(c, pair[k][0], &m, noise, 1.05, &worst);
    }
    note(c, "A/A", noise);
    return RL_OK;
}

/* The switch acts when colours are packed: no shader knows of it. */
static int claim_monochrome(const struct place *p, const char *mesh)
{
    double worst = NAN;
    struct rl_claim *c =
        begin(p, p->figure,
              "ours: shades of grey take as long as colours (Kajiya's and Goldman's; time of a "
              "frame over that in colour, 1 to within 5 %",
              mesh);
    if (!c)
        return RL_ERR_SYSTEM;
    double noise = noise_of(p);
    for (const char *const *e = rl_fur_models; *e; e++) {
        const struct rl_metric *m = metric_of(arm(p, *e, "phong", "on", "frame"), "time_to_pixel");
        if (!m || isnan(noise))
            continue;
        enum rl_verdict v = rl_verdict_equals(m->low - noise, m->high + noise, 1.0, 0.05);
        if (isnan(worst))
            c->verdict = RL_VERDICT_HOLDS;
        if (rl_judging_worse(c, v, fmax(m->high - 1.0, 1.0 - m->low), &worst))
            rl_claim_value(c, m->value, m->low, m->high, "times");
        note(c, *e, m->value);
    }
    note(c, "A/A", noise);
    return RL_OK;
}

/* ---- Errors ---- */

/* One of the RMSEs of pairs of pictures is the worst: the largest, or, of what is to be seen, the smallest. */
static int claim_rmse(const struct place *p, const char *series, const char *text, const char *mesh,
                      const char *figure, bool seen)
{
    double worst = NAN;
    struct rl_claim *c = begin(p, figure, text, mesh);
    if (!c)
        return RL_ERR_SYSTEM;
    for (const char *const *e = rl_fur_models; *e; e++) {
        char pattern[96];
        snprintf(pattern, sizeof pattern, "series=%s effect=%s", series, *e);
        const struct rl_metric *m = metric_of(find(p, pattern), "rmse");
        if (!m)
            continue;
        enum rl_verdict v = seen ? rl_verdict_at_least(m->low, m->high, RL_STEP_OF_8_BITS)
                                 : rl_verdict_at_most(m->low, m->high, RL_STEP_OF_8_BITS);
        if (isnan(worst))
            c->verdict = RL_VERDICT_HOLDS;
        if (rl_judging_worse(c, v, seen ? -m->value : m->value, &worst))
            rl_claim_value(c, m->value, m->low, m->high, "of full scale");
        note(c, *e, m->value);
    }
    return RL_OK;
}

/* The power of h = 1/tessellation that one model's error falls with. */
static struct rl_interval rate_of(const struct rl_judging *j, const char *effect)
{
    char pattern[96];
    double x[RL_AXIS_MAX], y[RL_AXIS_MAX];
    snprintf(pattern, sizeof pattern, "series=vertex effect=%s", effect);
    size_t n = rl_judging_axis(j, pattern, "tessellation", x), used = 0;
    for (size_t i = 0; i < n; i++) {
        struct place at = {j, (int)x[i], "vertex"};
        const struct rl_metric *m = metric_of(find(&at, pattern), "rmse");
        if (!m)
            continue;
        x[used] = x[i];
        y[used++] = m->value;
    }
    struct rl_interval slope = rl_loglog_slope(x, y, used, 0.95);
    return (struct rl_interval){-slope.value, -slope.high, -slope.low};
}

/* Kajiya's and Lengyel's radiance has corners at single points, which do not count. Goldman's kappa has no limit where N points at the light or
 * at the eye: there it is wrong by its whole range, over one triangle. */
static const struct {
    const char *text;
    bool goldman;
} rates[] = {
    {"ours: the error of fur at the vertices falls with the square of the edge (Kajiya's and Lengyel's; RMSE "
     "against fur at each pixel, power of h 1.7 or more)",
     false},
    {"ours: the error of Goldman's fur at the vertices falls more slowly, since kappa has no limit where N "
     "points at light or eye (as listed and corrected; power of h 1.7 or less)",
     true},
};

static int claim_rates(const struct rl_judging *j)
{
    for (size_t k = 0; k < sizeof rates / sizeof rates[0]; k++) {
        double worst = NAN;
        struct rl_claim *c = rl_judging_claim(j, rates[k].text);
        if (!c)
            return RL_ERR_SYSTEM;
        c->figure = "vertex";
        for (const char *const *e = rl_fur_models; *e; e++) {
            bool goldman = strncmp(*e, "goldman", strlen("goldman")) == 0;
            struct rl_interval r = {NAN, NAN, NAN};
            if (goldman == rates[k].goldman)
                r = rate_of(j, *e);
            if (isnan(r.value))
                continue;
            enum rl_verdict v =
                goldman ? rl_verdict_at_most(r.low, r.high, 1.7) : rl_verdict_at_least(r.low, r.high, 1.7);
            if (isnan(worst))
                c->verdict = RL_VERDICT_HOLDS;
            if (rl_judging_worse(c, v, goldman ? r.value : -r.value, &worst))
                rl_claim_value(c, r.value, r.low, r.high, "power of h");
            note(c, *e, r.value);
        }
    }
    return RL_OK;
}

/* ---- All ---- */

static int judge_times(const struct place *p, const char *mesh)
{
    static int (*const claim[])(const struct place *, const char *) = {claim_vertices, claim_against_phong,
                                                                       claim_correcting, claim_monochrome};
    int status = RL_OK;
    for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
        status = claim[k](p, mesh);
    return status;
}

/* On the ball with the fewest triangles that are timed all of the claims on time, with the most that on vertices; the error likewise. */
static int judge_ball(const struct rl_judging *j)
{
    static const char few[] = ", the fewest triangles timed)", many[] = ", the most triangles timed)";
    static const char text[] =
        "ours: fur at the vertices is to the eye what it is at each pixel (every model; RMSE "
        "against that, at most 1/255";
    double timed[RL_AXIS_MAX], shown[RL_AXIS_MAX];
    size_t n = rl_judging_axis(j, "series=time", "tessellation", timed);
    size_t m = rl_judging_axis(j, "series=mono", "tessellation", shown);
    const struct place least = {j, n > 0 ? (int)timed[0] : 1, "time"};
    const struct place most = {j, n > 0 ? (int)timed[n - 1] : 1, "time-many"};
    const struct place mono = {j, m > 0 ? (int)shown[0] : 1, "sheet"};
    int status = claim_rmse(&least, "vertex", text, few, "vertex", false);
    if (status == RL_OK)
        status = claim_rmse(&most, "vertex", text, many, "vertex", false);
    if (status == RL_OK)
        status = claim_rates(j);
    if (status == RL_OK)
        status = judge_times(&least, few);
    if (status == RL_OK)
        status = claim_vertices(&most, many);
    return status == RL_OK
               ? claim_rmse(&mono, "mono",
                            "ours: shades of grey in place of colours are seen (every model; RMSE, "
                            "at least 1/255",
                            ")", "sheet", true)
               : status;
}

int rl_fur_judge_costs(const struct rl_judging *j)
{
    if (strcmp(j->scene, RL_NO_SCENE) == 0)
        return judge_ball(j);
    const struct place as_it_is = {j, 0, "time"};
    int status = claim_rmse(&as_it_is, "vertex",
                            "ours: fur at the vertices is to the eye what it is at each pixel (every model; "
                            "RMSE against that, at most 1/255",
                            "", "error", false);
    return status == RL_OK ? judge_times(&as_it_is, "") : status;
}
