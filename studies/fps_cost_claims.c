/* The claims that the study `fps` judges on what things cost: whether cost models describe the times, and what they say (see fps.h). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "measure/statistics.h"
#include "studies/fps.h"
#include "studies/fps_notes.h"

static struct rl_claim *begin_claim(const struct rl_fps_costs *k, const char *figure, const char *text)
{
    struct rl_claim *c = rl_judging_claim(&k->measured, text);
    if (c)
        c->figure = figure;
    return c;
}

/* How far apart two arms of the same work were beside this model's cases; infinite: nobody knows. */
static double noise_floor(const struct rl_fps_costs *k, const char *model)
{
    const struct rl_metric *m = rl_fps_model_metric(k, model, "noise_floor");
    return m ? m->value : INFINITY;
}

/* What two equal arms may differ by decides nothing, in either direction. */
static enum rl_verdict at_most(struct rl_interval x, double bound, double floor)
{
    if (x.high + floor <= bound)
        return RL_VERDICT_HOLDS;
    return x.low - floor > bound ? RL_VERDICT_FAILS : RL_VERDICT_INCONCLUSIVE;
}

/* Whether a model describes its series. A residual within what equal arms differ by is no fault of the model. */
static int claim_fit(const struct rl_fps_costs *k, const char *model, const char *figure, const char *text)
{
    static const double bound = 0.05;
    char words[200];
    snprintf(words, sizeof words, "%s: no case is off by more than 5 %%", text);
    struct rl_claim *c = begin_claim(k, figure, words);
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *worst = rl_fps_model_metric(k, model, "worst_residual");
    rl_fps_note_refusal(c, k, model);
    if (!worst)
        return RL_OK;
    rl_claim_value(c, worst->value, worst->low, worst->high, "of the time");
    rl_fps_note_fit(c, k, model);
    if (worst->high <= bound)
        c->verdict = RL_VERDICT_HOLDS;
    else if (worst->low - noise_floor(k, model) > bound)
        c->verdict = RL_VERDICT_FAILS;
    return RL_OK;
}

static int claim_fits(const struct rl_fps_costs *k)
{
    static const struct {
        const char *model, *figure, *text;
    } fit[] = {
        {"none", "scaling", "ours: the frame without highlight takes a + b x pixels"},
        {"plain", "scaling", "ours: what plain adds to it is a + b x pixels"},
        {"random", "scaling", "ours: what random adds to it is a + b x pixels x samples"},
        {"random-pixels", "scaling", "ours: what random adds to it is a + b x pixels + c x pixels x samples"},
        {"regular", "scaling", "ours: what regular adds to it is a + b x pixels x samples"},
        {"regular-pixels", "scaling",
         "ours: what regular adds to it is a + b x pixels + c x pixels x samples"},
        {"environment-pass", "environment", "ours: drawing an environment map takes a + b x texels"},
        {"objects-pass", "objects", "ours: drawing the environment maps takes a + b x objects"},
        {"maps", "maps", "ours: baking normal maps takes a + b x roughnesses"},
        {"exhaustive", "exhaustive", "ours: exhaustive takes a + b x pixels + c x texel-normals"},
    };
    int status = RL_OK;
    for (size_t i = 0; i < sizeof fit / sizeof fit[0] && status == RL_OK; i++)
        status = claim_fit(k, fit[i].model, fit[i].figure, fit[i].text);
    return status;
}

/* One model's coefficient over another's, at most `bound`. */
static int claim_ratio(const struct rl_fps_costs *k, const char *figure, const char *text, const char *a,
                       const char *b, const char *metric, double bound, const char *unit)
{
    struct rl_claim *c = begin_claim(k, figure, text);
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *x = rl_fps_model_metric(k, a, metric), *y = rl_fps_model_metric(k, b, metric);
    rl_fps_note_refusal(c, k, a);
    rl_fps_note_refusal(c, k, b);
    if (!x || !y)
        return RL_OK;
    rl_fps_note_term(c, x, a);
    rl_fps_note_term(c, y, b);
    if (!(y->low > 0.0)) /* the divisor may be nothing: so may be anything the ratio */
        return RL_OK;
    rl_judging_ratio(c, x, y, unit);
    c->verdict = at_most((struct rl_interval){c->value, c->low, c->high}, bound, noise_floor(k, a));
    return RL_OK;
}

/* One more of something, in parts of what the highlight adds with one. */
static int claim_one_more(const struct rl_fps_costs *k, const char *text, const char *model, double bound)
{
    struct rl_claim *c = begin_claim(k, "roughness", text);
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *constant = rl_fps_model_metric(k, model, "constant_ms");
    const struct rl_metric *each = rl_fps_model_metric(k, model, "per_roughness_us");
    rl_fps_note_refusal(c, k, model);
    if (!constant || !each)
        return RL_OK;
    double one = 1000.0 * constant->value + each->value;
    rl_claim_value(c, each->value / one, each->low / one, each->high / one, "of what the highlight adds");
    c->verdict = at_most((struct rl_interval){c->value, c->low, c->high}, bound, noise_floor(k, model));
    rl_fps_note_fit(c, k, model);
    return RL_OK;
}

/* Up to which picture size an arm keeps to 24 frames a second. If at all, or at none, the rate of the largest or the smallest is shown. */
static int claim_reach(const struct rl_fps_costs *k, const char *arm, const char *text)
{
    struct rl_claim *c = begin_claim(k, "scaling", text);
    if (!c)
        return RL_ERR_SYSTEM;
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=size arm=%s", arm);
    double width[RL_AXIS_MAX], pixels[RL_AXIS_MAX], failing = INFINITY;
    size_t n = rl_judging_axis(&k->measured, pattern, "width", width), held = 0;
    const struct rl_metric *beyond = NULL;
    for (size_t i = 0; i < n && isinf(failing); i++) {
        char case_of[160];
        snprintf(case_of, sizeof case_of, "%s width=%.17g", pattern, width[i]);
        const struct rl_record *r = rl_run_find(k->measured.run, k->measured.scene, case_of);
        const struct rl_metric *fps = r ? rl_record_metric(r, "fps") : NULL;
        if (!fps)
            return RL_OK;
        double height = rl_parameter_number(r->parameters, "height");
        enum rl_verdict verdict = rl_verdict_at_least(fps->low, fps->high, RL_FILM_FPS);
        pixels[i] = width[i] * height;
        beyond = held == i ? fps : beyond;
        held += held == i && verdict == RL_VERDICT_HOLDS;
        failing = verdict == RL_VERDICT_FAILS ? pixels[i] : failing;
        size_t used = strlen(c->note);
        snprintf(c->note + used, sizeof c->note - used, "%s%gx%g: %.3g frames/s", used ? "; " : "", width[i],
                 height, fps->value);
    }
    if (n == 0 || !beyond)
        return RL_OK;
    if (held > 0 && held < n)
        rl_claim_value(c, pixels[held - 1], pixels[held - 1], failing, "px");
    else
        rl_claim_value(c, beyond->value, beyond->low, beyond->high, "frames/s");
    c->verdict = held == n  ? RL_VERDICT_HOLDS
                 : held > 0 ? RL_VERDICT_HOLDS_UP_TO
                            : rl_verdict_at_least(beyond->low, beyond->high, RL_FILM_FPS);
    return RL_OK;
}

/* The largest environment map in place of the smallest, in the frame that looks it up; paired by round. */
static int claim_map_size(const struct rl_fps_costs *k)
{
    struct rl_claim *c =
        begin_claim(k, "environment",
                    "ours: the largest environment map measured in place of the smallest slows the frame of "
                    "random 4 by no more than 10 %");
    if (!c)
        return RL_ERR_SYSTEM;
    double size[RL_AXIS_MAX];
    size_t n = rl_judging_axis(&k->measured, "series=environment arm=random-4", "env_size", size);
    char pattern[2][96];
    const struct rl_series *time[2] = {NULL, NULL};
    for (int i = 0; i < 2 && n > 1; i++) {
        snprintf(pattern[i], sizeof pattern[i], "series=environment arm=random-4 env_size=%.17g",
                 size[i ? n - 1 : 0]);
        const struct rl_record *r = rl_run_find(k->measured.run, k->measured.scene, pattern[i]);
        time[i] = r ? rl_record_series(r, "frame_ms") : NULL;
    }
    if (!time[0] || !time[1])
        return RL_OK;
    size_t rounds = time[0]->n < time[1]->n ? time[0]->n : time[1]->n;
    struct rl_interval x =
        rl_interval_from_0(rl_ratio_interval(time[1]->value, time[0]->value, rounds, 0.95));
    rl_claim_value(c, x.value, x.low, x.high, "times");
    c->verdict = at_most(x, 1.1, noise_floor(k, "environment-frame"));
    snprintf(c->note, sizeof c->note, "%g against %g texels along an edge", size[n - 1], size[0]);
    return RL_OK;
}

/* Counted, not timed. */
static int claim_maps_of_objects(const struct rl_fps_costs *k)
{
    struct rl_claim *c = begin_claim(k, "objects", "paper: every object has an environment map of its own");
    if (!c)
        return RL_ERR_SYSTEM;
    double least = INFINITY, most = -INFINITY;
    for (const struct rl_record *r = NULL;
         (r = rl_run_next(k->measured.run, r, k->measured.scene, "series=objects arm=random-4"));) {
        const struct rl_metric *maps = rl_record_metric(r, "env_maps");
        double each = maps ? maps->value / rl_parameter_number(r->parameters, "objects") : NAN;
        least = fmin(least, each);
        most = fmax(most, each);
    }
    if (!(most >= least))
        return RL_OK;
    rl_claim_value(c, most, least, most, "maps an object");
    c->verdict = rl_verdict_equals(least, most, 1.0, 0.0);
    return RL_OK;
}

static int claim_baking(const struct rl_fps_costs *k)
{
    struct rl_claim *c = begin_claim(
        k, "maps", "ours: the normal map of one more roughness is made within a frame of 24 frames/s, once");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *each = rl_fps_model_metric(k, "maps", "per_roughness_us");
    rl_fps_note_refusal(c, k, "maps");
    if (!each)
        return RL_OK;
    rl_claim_value(c, 1e-3 * each->value, 1e-3 * each->low, 1e-3 * each->high, "ms");
    c->verdict = rl_verdict_at_most(c->low, c->high, 1000.0 / RL_FILM_FPS);
    rl_fps_note_fit(c, k, "maps");
    return RL_OK;
}

/* The exhaustive case of most texel-normals. */
static const struct rl_record *largest_exhaustive(const struct rl_fps_costs *k)
{
    const struct rl_record *found = NULL;
    double most = 0.0;
    for (const struct rl_record *r = NULL;
         (r = rl_run_next(k->measured.run, r, k->measured.scene, "series=exhaustive arm=exhaustive"));) {
        const struct rl_metric *m = rl_record_metric(r, "texel_normals");
        if (m && m->value > most) {
            most = m->value;
            found = r;
        }
    }
    return found;
}

static int claim_exhaustive(const struct rl_fps_costs *k)
{
    struct rl_claim *c =
        begin_claim(k, "exhaustive",
                    "paper: every texel at every pixel is no way to real time: exhaustive takes more than "
                    "1/24 s a frame even at the small size measured");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_record *r = largest_exhaustive(k);
    const struct rl_metric *ms = r ? rl_record_metric(r, "frame_ms") : NULL;
    if (!ms)
        return RL_OK;
    rl_claim_value(c, ms->value, ms->low, ms->high, "ms");
    c->verdict = rl_verdict_at_least(ms->low, ms->high, 1000.0 / RL_FILM_FPS);
    snprintf(c->note, sizeof c->note, "%gx%g, %g texels along an edge of the map, on the CPU",
             rl_parameter_number(r->parameters, "width"), rl_parameter_number(r->parameters, "height"),
             rl_parameter_number(r->parameters, "env_size"));
    return RL_OK;
}

/* At the size of Table 1 by the model alone: texel-normals grow with the pixels and with the map's texels. */
static int claim_extrapolated(const struct rl_fps_costs *k)
{
    struct rl_claim *c =
        begin_claim(k, "exhaustive",
                    "ours: by its model, not measured: exhaustive at 640x480 with a map of 256 takes more "
                    "than 1/24 s a frame");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_record *r = largest_exhaustive(k);
    const struct rl_metric *a = rl_fps_model_metric(k, "exhaustive", "constant_ms");
    const struct rl_metric *b = rl_fps_model_metric(k, "exhaustive", "per_drawn_pixel_ns");
    const struct rl_metric *d = rl_fps_model_metric(k, "exhaustive", "per_texel_normal_ns");
    rl_fps_note_refusal(c, k, "exhaustive");
    if (!r || !a || !b || !d)
        return RL_OK;
    const char *p = r->parameters;
    double edges = 256.0 / rl_parameter_number(p, "env_size");
    double times = 640.0 * 480.0 / (rl_parameter_number(p, "width") * rl_parameter_number(p, "height"));
    double pixels = times * rl_record_metric(r, "drawn_px")->value;
    double texels = times * edges * edges * rl_record_metric(r, "texel_normals")->value;
    double seconds = 1e-3 * a->value + 1e-9 * (b->value * pixels + d->value * texels);
    snprintf(c->note, sizeof c->note,
             "a + b x %.3g pixels + c x %.3g texel-normals, %.3g times the most that was measured%s", pixels,
             texels, times * edges * edges, seconds > 0.0 ? "" : "; left out: no time above 0 is predicted");
    if (!(seconds > 0.0))
        return RL_OK;
    /* The ends of all three together: wider than 95 %. */
    rl_claim_value(c, seconds, 1e-3 * a->low + 1e-9 * (b->low * pixels + d->low * texels),
                   1e-3 * a->high + 1e-9 * (b->high * pixels + d->high * texels), "s, extrapolated");
    c->verdict = rl_verdict_at_least(c->low, c->high, 1.0 / RL_FILM_FPS);
    return RL_OK;
}

static int judge_scene(const struct rl_fps_costs *k)
{
    int status = claim_fits(k);
    if (status == RL_OK)
        status = claim_ratio(k, "scaling",
                             "ours: a normal of the fixed pattern costs no more than one from the normal map",
                             "regular-pixels", "random-pixels", "per_sample_ns", 1.0, "times");
    if (status == RL_OK)
        status = claim_reach(k, "random-4",
                             "paper: in real time: random 4 keeps to 24 frames/s at every size measured");
    if (status == RL_OK)
        status = claim_reach(k, "regular-13",
                             "paper: in real time: regular 13 keeps to 24 frames/s at every size measured");
    if (status == RL_OK)
        status = claim_map_size(k);
    if (status == RL_OK)
        status = claim_maps_of_objects(k);
    if (status == RL_OK)
        status = claim_ratio(k, "objects",
                             "ours: an object more, of as many pixels together, adds to the highlight's time "
                             "what drawing it once more takes, and no more (to within a quarter)",
                             "objects-frame", "objects-none", "per_object_us", 1.25, "times");
    if (status == RL_OK)
        status = claim_one_more(k, "ours: one more roughness adds no more than 5 % to what random 4 adds",
                                "roughness-frame", 0.05);
    if (status == RL_OK)
        status =
            claim_one_more(k,
                           "ours: one more roughness, with bounding spheres of its own, adds no more than "
                           "5 % to what random 4 adds",
                           "roughness-margin", 0.05);
    if (status == RL_OK)
        status = claim_baking(k);
    if (status == RL_OK)
        status = claim_exhaustive(k);
    return status == RL_OK ? claim_extrapolated(k) : status;
}

/* Whether more than Table 1 was planned on the scene. */
static bool has_costs(const struct rl_run *run, const char *scene)
{
    for (size_t i = 0; i < run->n_records; i++)
        if (strcmp(run->record[i].scene, scene) == 0 &&
            !rl_parameters_match(run->record[i].parameters, "series=table1"))
            return true;
    return false;
}

int rl_fps_judge_costs(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    struct rl_run models;
    int status = rl_fps_derive(&models, run, error);
    if (status != RL_OK)
        return status;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        struct rl_fps_costs costs = {{run, scene, claims, error}, {&models, scene, claims, error}};
        if (has_costs(run, scene))
            status = judge_scene(&costs);
    }
    rl_run_clear(&models);
    return status;
}
