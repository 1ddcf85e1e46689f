/* The claims that the study `interpolation` judges. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/interpolation.h"
#include "studies/judging.h"
#include "studies/timing_arms.h"

static const char *const objects[] = {"sphere", "teapot"};
enum { OBJECTS = 2 };

/* A claim of one object, whose name takes the place of %s, shown by a figure of `figure` and the object. */
static struct rl_claim *begin(const struct rl_judging *j, const char *object, const char *before,
                              const char *after, const char *figure)
{
    char text[256];
    snprintf(text, sizeof text, "%s%s%s", before, object, after);
    struct rl_claim *c = rl_judging_claim(j, text);
    if (c)
        c->figure = figure;
    return c;
}

static void note(struct rl_claim *c, const char *what, double value)
{
    size_t used = strlen(c->note);
    if (isnan(value))
        return;
    snprintf(c->note + used, sizeof c->note - used, "%s%s: %.4g", used ? "; " : "", what, value);
}

/* ---- Rates ---- */

/* What theory has them be: radiance or normal linear in place of curved, or constant in place of linear. */
static const struct {
    const char *interpolation, *before, *after;
    double power, margin;
} rates[] = {
    {"phong", "ours: Phong shading's error falls with the square of the edge (RMSE, ",
     "; power of h 2 to within 0.2)", 2.0, 0.2},
    {"gouraud", "ours: Gouraud shading's error falls with the square of the edge (RMSE, ",
     "; power of h 2 to within 0.2)", 2.0, 0.2},
    {"constant", "ours: constant shading's error falls with the edge (RMSE, ",
     "; power of h 1 to within 0.1)", 1.0, 0.1},
};

static int claim_rates(const struct rl_judging *j, const char *object)
{
    for (size_t k = 0; k < sizeof rates / sizeof rates[0]; k++) {
        struct rl_claim *c = begin(j, object, rates[k].before, rates[k].after, object);
        if (!c)
            return RL_ERR_SYSTEM;
        struct rl_interpolation_rates r =
            rl_interpolation_rates(j->run, object, "eye", rates[k].interpolation);
        rl_claim_value(c, r.rate.value, r.rate.low, r.rate.high, "power of h");
        c->verdict = rl_verdict_equals(c->low, c->high, rates[k].power, rates[k].margin);
        note(c, "from tessellation", r.from_tessellation);
        note(c, "terminator in view",
             rl_interpolation_rates(j->run, object, "side", rates[k].interpolation).rate.value);
    }
    return RL_OK;
}

/* Where N.L changes sign radiance has a corner, within one row of triangles: of its own that would fall with h^1.5. */
static int claim_terminator(const struct rl_judging *j)
{
    struct rl_claim *c =
        begin(j, "sphere", "ours: a terminator in view slows the fall of Gouraud shading's error (",
              "; power of h lit from the eye less that lit from the side, above 0)", "sphere");
    if (!c)
        return RL_ERR_SYSTEM;
    struct rl_interval eye = rl_interpolation_rates(j->run, "sphere", "eye", "gouraud").rate;
    struct rl_interval side = rl_interpolation_rates(j->run, "sphere", "side", "gouraud").rate;
    rl_claim_value(c, eye.value - side.value, eye.low - side.high, eye.high - side.low, "power of h");
    c->verdict = rl_verdict_at_least(c->low, c->high, 0.0);
    note(c, "from the eye", eye.value);
    note(c, "from the side", side.value);
    return RL_OK;
}

/* ---- Triangles ---- */

static const struct {
    const char *more, *less, *before;
} triangles[] = {
    {"gouraud", "phong",
     "ours: Gouraud shading takes at least three times the triangles of Phong shading for an RMSE of 1/255 "
     "("},
    {"constant", "gouraud",
     "ours: constant shading takes at least three times the triangles of Gouraud shading for an RMSE of "
     "1/255 ("},
};

/* Where the coarsest mesh does, or the finest does not, there is only a bound. */
static void note_triangles(struct rl_claim *c, const char *what, const struct rl_interval *x)
{
    char text[128];
    size_t used = strlen(c->note);
    if (isnan(x->value))
        snprintf(text, sizeof text, "%.40s: at most %.4g, the coarsest", what, x->high);
    else
        snprintf(text, sizeof text, "%.40s: more than %.4g, the finest", what, x->low);
    if (!isnan(x->high) && !isfinite(x->value))
        snprintf(c->note + used, sizeof c->note - used, "%s%s", used ? "; " : "", text);
    else
        note(c, what, x->value);
}

/* How many times as many; where one of both is but a bound the value is one, too, the least that it can be. None where neither is known
 * from above. */
static void take_triangles(struct rl_claim *c, const struct rl_interval *more, const struct rl_interval *less)
{
    if (!isfinite(less->high) || isnan(more->high))
        return;
    double low = more->low / less->high;
    bool bound = !isfinite(more->value) || isnan(less->value);
    rl_claim_value(c, bound ? low : more->value / less->value, low,
                   less->low > 0.0 ? more->high / less->low : INFINITY,
                   bound ? "times the triangles or more" : "times the triangles");
}

static int claim_triangles(const struct rl_judging *j, const char *object)
{
    for (size_t k = 0; k < sizeof triangles / sizeof triangles[0]; k++) {
        struct rl_claim *c = begin(j, object, triangles[k].before, ")", object);
        if (!c)
            return RL_ERR_SYSTEM;
        struct rl_interval more = rl_interpolation_rates(j->run, object, "eye", triangles[k].more).triangles;
        struct rl_interval less = rl_interpolation_rates(j->run, object, "eye", triangles[k].less).triangles;
        take_triangles(c, &more, &less);
        c->verdict = rl_verdict_at_least(c->low, c->high, 3.0);
        note_triangles(c, triangles[k].more, &more);
        note_triangles(c, triangles[k].less, &less);
    }
    return RL_OK;
}

/* ---- Bands ---- */

static const struct rl_metric *on_line(const struct rl_judging *j, const char *object, const char *surface,
                                       const char *interpolation, const char *metric)
{
    char pattern[160];
    snprintf(pattern, sizeof pattern, "series=bands object=%s surface=%s interpolation=%s", object, surface,
             interpolation);
    return rl_judging_metric(j, pattern, metric);
}

static int claim_step(const struct rl_judging *j, const char *object, const char *figure)
{
    struct rl_claim *c =
        begin(j, object, "ours: constant shading steps from triangle to triangle by more than 1/255 (", ")",
              figure);
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *step = on_line(j, object, "mesh", "constant", "step");
    if (step)
        rl_claim_value(c, step->value, step->low, step->high, "of full scale");
    c->verdict = rl_verdict_at_least(c->low, c->high, RL_STEP_OF_8_BITS);
    return RL_OK;
}

/* A corner of radiance along the line, over the steepest that the surface itself is there. Neither has to do with pixels: a change of slope
 * from one to the next, of a smooth radiance, is its second derivative times the pixel's width, and a ratio to that grows with the picture.
 * What radiance linear between knots h apart has as jump is the second difference of the surface's own radiance over h: all that its slope
 * changes by from edge to edge, at once; where an edge is as wide as the highlight's flank that is as much as the slope itself. */
static int claim_jumps(const struct rl_judging *j, const char *object, const char *figure, bool gouraud)
{
    static const char *const before[] = {
        "ours: Phong shading leaves no Mach bands: at no edge does its slope "
        "jump by more than a tenth of the surface's own largest slope (",
        "ours: Gouraud shading makes Mach bands: at an edge its slope jumps "
        "by at least half of the surface's own largest slope ("};
    struct rl_claim *c = begin(j, object, before[gouraud], ")", figure);
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *jump = on_line(j, object, "mesh", gouraud ? "gouraud" : "phong", "jump");
    const struct rl_metric *slope = on_line(j, object, "exact", "phong", "slope");
    const struct rl_metric *own = on_line(j, object, "exact", "phong", "jump");
    if (jump && slope) {
        rl_judging_ratio(c, jump, slope, "of the slope");
        note(c, "the surface's own slope", slope->value);
        note(c, "and what is found as its jump", own ? own->value : NAN);
    }
    c->verdict =
        gouraud ? rl_verdict_at_least(c->low, c->high, 0.5) : rl_verdict_at_most(c->low, c->high, 0.1);
    return RL_OK;
}

static int claim_bands(const struct rl_judging *j, const char *object)
{
    const char *figure = strcmp(object, "sphere") == 0 ? "bands" : "teapot-bands";
    int status = claim_step(j, object, figure);
    if (status == RL_OK)
        status = claim_jumps(j, object, figure, true);
    return status == RL_OK ? claim_jumps(j, object, figure, false) : status;
}

/* ---- Time ---- */

/* A frame of the sphere with the fewest or the most triangles that were timed, against the same by Phong shading. */
static int claim_time(const struct rl_judging *j, const char *interpolation, const char *words, bool many)
{
    char text[256], pattern[160];
    double tessellation[RL_AXIS_MAX];
    snprintf(text, sizeof text,
             "ours: %s takes no longer than Phong shading (a frame of the sphere, %s triangles timed)", words,
             many ? "the most" : "the fewest");
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "time";
    size_t n = rl_judging_axis(j, "series=time object=sphere arm=frame", "tessellation", tessellation);
    if (n == 0)
        return RL_OK;
    double at = tessellation[many ? n - 1 : 0];
    snprintf(pattern, sizeof pattern, "series=time object=sphere tessellation=%g interpolation=%s arm=frame",
             at, interpolation);
    const struct rl_metric *ratio = rl_judging_metric(j, pattern, "time_to_phong");
    const struct rl_metric *count = rl_judging_metric(j, pattern, "triangles");
    snprintf(pattern, sizeof pattern, "series=time object=sphere tessellation=%g arm=again", at);
    double noise = rl_arms_noise(rl_judging_metric(j, pattern, "time_to_phong"));
    if (ratio)
        rl_claim_value(c, ratio->value, ratio->low, ratio->high, "times");
    c->verdict = rl_arms_at_most(ratio, noise, 1.0);
    note(c, "triangles", count ? count->value : NAN);
    note(c, "A/A", noise);
    return RL_OK;
}

int rl_interpolation_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    const struct rl_judging j = {run, RL_NO_SCENE, claims, error};
    int status = RL_OK;
    for (int o = 0; o < OBJECTS && status == RL_OK; o++)
        status = claim_rates(&j, objects[o]);
    if (status == RL_OK)
        status = claim_terminator(&j);
    for (int o = 0; o < OBJECTS && status == RL_OK; o++)
        status = claim_triangles(&j, objects[o]);
    for (int o = 0; o < OBJECTS && status == RL_OK; o++)
        status = claim_bands(&j, objects[o]);
    for (int many = 0; many < 2 && status == RL_OK; many++) {
        status = claim_time(&j, "gouraud", "Gouraud shading", many);
        if (status == RL_OK)
            status = claim_time(&j, "constant", "constant shading", many);
    }
    return status;
}
