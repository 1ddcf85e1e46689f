/* Claims of the study `visibility`: each along far/near, or of the frames with back faces and without. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "measure/statistics.h"
#include "studies/judging.h"
#include "studies/timing_arms.h"
#include "studies/visibility.h"

/* One pixel in a thousand. */
static const double few = 1e-3;

/* How far a share may be from what it is held against, relative to that: an ideal depth buffer's, and another format's. */
static const double alike = 0.1, same_format = 0.2;

/* How many more pixels may be wrong for a near plane that is nearer: few beside what other depth buffers get wrong then. */
static const double few_more = 5e-3;

/* Shares below this are of a handful of pixels. */
static const double enough = 1e-3;

/* Steps of a depth buffer that single precision may add before it. */
static const double room_steps = 4.0;

static const char bits_16[] = "depth_bits=16 reversed_depth=off",
                  bits_24[] = "depth_bits=24 reversed_depth=off",
                  bits_32[] = "depth_bits=32 reversed_depth=off",
                  reversed_32[] = "depth_bits=32 reversed_depth=on";

static const struct rl_record *find(const struct rl_judging *j, const char *buffer, double ratio)
{
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=depth %s", buffer);
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, pattern));)
        if (rl_parameter_number(r->parameters, "ratio") == ratio)
            return r;
    return NULL;
}

static const struct rl_metric *metric(const struct rl_judging *j, const char *buffer, double ratio,
                                      const char *name)
{
    const struct rl_record *r = find(j, buffer, ratio);
    return r ? rl_record_metric(r, name) : NULL;
}

static void note(struct rl_claim *c, const char *what, double ratio, double value)
{
    size_t used = strlen(c->note);
    snprintf(c->note + used, sizeof c->note - used, "%s%s%g: %.3g", used ? "; " : "", used ? "" : what, ratio,
             value);
}

/* The mean over views of a - b, each view's own, over `whole`: views are of the same places. */
static struct rl_interval paired(const struct rl_series *a, const struct rl_series *b, double whole)
{
    enum { VIEWS_MAX = 64 };
    double off[VIEWS_MAX];
    size_t n = a && b && a->n == b->n && a->n <= VIEWS_MAX ? a->n : 0;
    bool same = n > 0;
    for (size_t i = 0; i < n; i++) {
        off[i] = (a->value[i] - b->value[i]) / whole;
        same = same && off[i] == off[0];
    }
    /* One view, or views that all agree, leave no interval. */
    return same ? rl_exact_interval(off[0]) : rl_mean_interval(off, n, 0.95);
}

/* How far behind the right surface the farthest wrong one lies. */
static int claim_steps(const struct rl_judging *j, const double *ratio, size_t n, const char *buffer,
                       const char *text, double bound)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "worst";
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *worst = metric(j, buffer, ratio[i], "worst");
        if (!worst)
            continue;
        note(c, "far/near ", ratio[i], worst->value);
        if (worst->value <= c->value)
            continue;
        rl_claim_value(c, worst->value, worst->low, worst->high, "steps");
        c->verdict = rl_verdict_at_most(worst->low, worst->high, bound);
    }
    return RL_OK;
}

/* Takes one more far/near into a claim that holds where every one does. */
static void take(struct rl_claim *c, struct rl_interval off, double margin, const char *unit, double *worst)
{
    enum rl_verdict verdict = rl_verdict_equals(off.low, off.high, 0.0, margin);
    if (rl_judging_worse(c, verdict, fabs(off.value), worst))
        rl_claim_value(c, off.value, off.low, off.high, unit);
}

/* Where at every far/near only a handful of pixels is wrong the number is the difference of both shares at the largest, of all pixels: what
 * it is of the smaller share is not known. */
static void take_few(struct rl_claim *c, const struct rl_record *a, const char *of_a,
                     const struct rl_record *b, const char *of_b, const char *words)
{
    const struct rl_series *x = a ? rl_record_series(a, of_a) : NULL,
                           *y = b ? rl_record_series(b, of_b) : NULL;
    if (!x || !y)
        return;
    struct rl_interval off = paired(x, y, 1.0);
    rl_claim_value(c, off.value, off.low, off.high, "of the pixels");
    snprintf(c->note, sizeof c->note, "%s at every far/near; the difference at the largest", words);
}

/* Measured shares against those of an ideal depth buffer. */
static int claim_ideal(const struct rl_judging *j, const double *ratio, size_t n, const char *buffer,
                       const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "wrong";
    double worst = NAN;
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = find(j, buffer, ratio[i]);
        const struct rl_metric *ideal = r ? rl_record_metric(r, "ideal") : NULL;
        if (!ideal || ideal->value < enough)
            continue;
        struct rl_interval off =
            paired(rl_record_series(r, "wrong"), rl_record_series(r, "ideal"), ideal->value);
        note(c, "far/near ", ratio[i], off.value);
        take(c, off, alike, "of the ideal share", &worst);
    }
    const struct rl_record *last = n > 0 ? find(j, buffer, ratio[n - 1]) : NULL;
    if (isnan(c->value))
        take_few(c, last, "wrong", last, "ideal", "an ideal one gets less than one pixel in 1000 wrong");
    return RL_OK;
}

/* Up to which far/near the share of wrong pixels is small. */
static int claim_reach(const struct rl_judging *j, const double *ratio, size_t n, const char *buffer,
                       const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "wrong";
    size_t held = 0, failing = n;
    const struct rl_metric *last = NULL;
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *wrong = metric(j, buffer, ratio[i], "wrong");
        enum rl_verdict verdict =
            wrong ? rl_verdict_at_most(wrong->low, wrong->high, few) : RL_VERDICT_INCONCLUSIVE;
        held += held == i && verdict == RL_VERDICT_HOLDS;
        failing = failing == n && verdict == RL_VERDICT_FAILS ? i : failing;
        last = held == i + 1 || i == 0 ? wrong : last;
        if (wrong)
            note(c, "far/near ", ratio[i], wrong->value);
    }
    if (held > 0 && held < n) {
        c->verdict = RL_VERDICT_HOLDS_UP_TO;
        rl_claim_value(c, ratio[held - 1], ratio[held - 1], failing < n ? ratio[failing] : INFINITY,
                       "far/near");
    } else if (last) {
        c->verdict = held == n ? RL_VERDICT_HOLDS : failing == 0 ? RL_VERDICT_FAILS : RL_VERDICT_INCONCLUSIVE;
        rl_claim_value(c, last->value, last->low, last->high, "of the pixels");
    }
    return RL_OK;
}

/* Float near depth 1 has the steps of 24 bits. */
static int claim_float(const struct rl_judging *j, const double *ratio, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: 32 bits of float in the usual order get as many pixels wrong as 24 "
                            "bits do (to within 20 %)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "wrong";
    double worst = NAN;
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *whole = find(j, bits_24, ratio[i]), *real = find(j, bits_32, ratio[i]);
        const struct rl_metric *wrong = whole ? rl_record_metric(whole, "wrong") : NULL;
        if (!real || !wrong || wrong->value < enough)
            continue;
        struct rl_interval off =
            paired(rl_record_series(real, "wrong"), rl_record_series(whole, "wrong"), wrong->value);
        note(c, "far/near ", ratio[i], off.value);
        take(c, off, same_format, "of the share with 24 bits", &worst);
    }
    if (isnan(c->value) && n > 0)
        take_few(c, find(j, bits_32, ratio[n - 1]), "wrong", find(j, bits_24, ratio[n - 1]), "wrong",
                 "24 bits get less than one pixel in 1000 wrong");
    return RL_OK;
}

static int claim_reversed(const struct rl_judging *j, const double *ratio, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: with 32 bits reversed the near plane may be as near as one likes: at "
                            "most 5 pixels in 1000 more are wrong");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "wrong";
    const struct rl_record *far = n > 1 ? find(j, reversed_32, ratio[0]) : NULL;
    const struct rl_record *near = n > 1 ? find(j, reversed_32, ratio[n - 1]) : NULL;
    if (!far || !near)
        return RL_OK;
    struct rl_interval more = paired(rl_record_series(near, "wrong"), rl_record_series(far, "wrong"), 1.0);
    rl_claim_value(c, more.value, more.low, more.high, "of the pixels");
    c->verdict = rl_verdict_at_most(more.low, more.high, few_more);
    snprintf(c->note, sizeof c->note, "far/near %g against %g", ratio[n - 1], ratio[0]);
    return RL_OK;
}

/* ---- Back faces ---- */

static double value_of(const struct rl_record *r, const char *name)
{
    const struct rl_metric *m = rl_record_metric(r, name);
    return m ? m->value : NAN;
}

/* Of the methods and depth buffers the one with most pixels changed; NULL: not measured. */
static const struct rl_record *most_changed(const struct rl_judging *j, const char *name)
{
    const struct rl_record *most = NULL;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "series=culling arm=off"));)
        if (!most || value_of(r, name) > value_of(most, name))
            most = r;
    return most;
}

static int claim_no_pixel(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: culling back faces changes no pixel, bit for bit");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "culling";
    const struct rl_record *r = most_changed(j, "changed");
    if (!r)
        return RL_OK;
    double changed = value_of(r, "changed");
    rl_claim_value(c, changed, changed, changed, "pixels");
    c->verdict = rl_verdict_at_most(changed, changed, 0.0);
    snprintf(c->note, sizeof c->note, "of %g in all views; %s", value_of(r, "pixels"),
             value_of(r, "closed") > 0.0 ? "every mesh is closed" : "not every mesh is closed");
    return RL_OK;
}

/* Only where every mesh is closed. Corners are rounded to a grid finer than a pixel, and beyond its outline a surface's back is nearer than
 * its front. */
static int claim_outlines(const struct rl_judging *j)
{
    const struct rl_record *most = most_changed(j, "changed_sure");
    if (most && !(value_of(most, "closed") > 0.0))
        return RL_OK;
    struct rl_claim *c = rl_judging_claim(j, "ours: of closed meshes culling changes no pixel that is more "
                                             "than 1/64 of its width inside of a triangle");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "culling";
    const struct rl_record *r = most_changed(j, "changed_sure"); /* once more: now the claim takes note */
    if (!r)
        return RL_OK;
    double changed = value_of(r, "changed_sure");
    rl_claim_value(c, changed, changed, changed, "pixels");
    c->verdict = rl_verdict_at_most(changed, changed, 0.0);
    snprintf(c->note, sizeof c->note, "of %g in all views", value_of(r, "sure_pixels"));
    return RL_OK;
}

/* Where any triangle turns its back. */
static int claim_triangles(const struct rl_judging *j)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: culling leaves out about half of the triangles (0.4 to 0.6)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "culling";
    const struct rl_record *r = most_changed(j, "changed");
    if (!r)
        return RL_OK;
    double triangles = value_of(r, "triangles"), share = value_of(r, "back_faces") / triangles;
    rl_claim_value(c, share, share, share, "of the triangles");
    c->verdict = rl_verdict_equals(share, share, 0.5, 0.1);
    snprintf(c->note, sizeof c->note, "%g of %g", value_of(r, "back_faces"), triangles);
    return RL_OK;
}

static int claim_time(const struct rl_judging *j, const char *method, const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    char off[96], again[96];
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "culling";
    snprintf(off, sizeof off, "series=culling arm=off method=%s depth_bits=24", method);
    snprintf(again, sizeof again, "series=culling arm=again method=%s depth_bits=24", method);
    const struct rl_metric *times = rl_judging_metric(j, off, "time_to_on");
    double noise = rl_arms_noise(rl_judging_metric(j, again, "time_to_on"));
    if (!times || isnan(noise))
        return RL_OK;
    rl_claim_value(c, times->value, times->low, times->high, "times");
    c->verdict = rl_verdict_at_least(times->low - noise, times->high + noise, 1.0);
    snprintf(c->note, sizeof c->note, "A/A: %.3g", noise);
    return RL_OK;
}

static int judge_depth(const struct rl_judging *j)
{
    double ratio[RL_AXIS_MAX];
    size_t n = rl_judging_axis(j, "series=depth", "ratio", ratio);
    int status =
        claim_reach(j, ratio, n, bits_16, "ours: 16 bits show the right surface in all but 1 pixel in 1000");
    if (status == RL_OK)
        status = claim_reach(j, ratio, n, bits_24,
                             "ours: 24 bits show the right surface in all but 1 pixel in 1000");
    if (status == RL_OK)
        status = claim_reach(j, ratio, n, reversed_32,
                             "ours: 32 bits reversed show the right surface in all but 1 pixel in 1000");
    if (status == RL_OK)
        status = claim_steps(
            j, ratio, n, bits_16,
            "ours: with 16 bits no surface shows through one that is a step, z^2/(near 2^16), before it",
            1.0);
    if (status == RL_OK)
        status = claim_steps(
            j, ratio, n, bits_24,
            "ours: with 24 bits no surface shows through one that is a step, z^2/(near 2^24), before it",
            1.0);
    if (status == RL_OK)
        status = claim_steps(j, ratio, n, bits_24,
                             "ours: nor with 24 bits through one that is 4 steps before it", room_steps);
    if (status == RL_OK)
        status = claim_ideal(
            j, ratio, n, bits_16,
            "ours: with 16 bits as many pixels are wrong as with an ideal depth buffer (to within 10 %)");
    if (status == RL_OK)
        status = claim_ideal(
            j, ratio, n, bits_24,
            "ours: with 24 bits as many pixels are wrong as with an ideal depth buffer (to within 10 %)");
    if (status == RL_OK)
        status = claim_float(j, ratio, n);
    return status == RL_OK ? claim_reversed(j, ratio, n) : status;
}

static int judge_culling(const struct rl_judging *j)
{
    int status = claim_no_pixel(j);
    if (status == RL_OK)
        status = claim_outlines(j);
    const struct rl_record *r = most_changed(j, "changed");
    if (status != RL_OK || (r && !(value_of(r, "back_faces") > 0.0)))
        return status;
    status = claim_triangles(j);
    if (status == RL_OK)
        status = claim_time(
            j, "none",
            "ours: culling saves time: surfaces alone take longer with back faces, by more than noise");
    return status == RL_OK
               ? claim_time(
                     j, "random",
                     "ours: culling saves time: with 4 random normals, where the scene has highlights, too")
               : status;
}

int rl_visibility_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        const struct rl_judging j = {run, scene, claims, error};
        status = judge_depth(&j);
        if (status == RL_OK)
            status = judge_culling(&j);
    }
    return status;
}
