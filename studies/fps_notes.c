/* Notes of the claims on what things cost: coefficients, the case that a model describes worst, why one could not be fitted (see
 * fps_notes.h). */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "measure/fit.h"
#include "studies/fps.h"
#include "studies/fps_notes.h"

const struct rl_metric *rl_fps_model_metric(const struct rl_fps_costs *k, const char *model,
                                            const char *metric)
{
    char pattern[64];
    snprintf(pattern, sizeof pattern, "model=%s", model);
    rl_fps_read_cases(k->measured.run, k->measured.scene, model);
    return rl_judging_metric(&k->models, pattern, metric);
}

/* Adds to a note what there is room for. */
static void add(struct rl_claim *c, const char *format, ...)
{
    size_t used = strlen(c->note);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(c->note + used, sizeof c->note - used, format, arguments);
    va_end(arguments);
}

/* Adds ", b 1.25 ns" with its interval. */
void rl_fps_note_term(struct rl_claim *c, const struct rl_metric *m, const char *name)
{
    size_t used = strlen(c->note);
    if (m)
        snprintf(c->note + used, sizeof c->note - used, "%s%s %.3g [%.3g, %.3g] %s", used ? "; " : "", name,
                 m->value, m->low, m->high, m->unit);
}

/* " width 320 N 4": the case that a model describes worst, or cannot be fitted to. */
static void note_case(struct rl_claim *c, const struct rl_fps_costs *k, const char *model, const char *which)
{
    static const char *const key[][2] = {{"width", "width"},
                                         {"samples", "N"},
                                         {"env_size", "map"},
                                         {"objects", "objects"},
                                         {"roughnesses", "roughnesses"}};
    for (size_t i = 0; i < sizeof key / sizeof key[0]; i++) {
        char name[RL_NAME_MAX];
        snprintf(name, sizeof name, "%s_%s", which, key[i][0]);
        const struct rl_metric *m = rl_fps_model_metric(k, model, name);
        if (m)
            add(c, " %s %g", key[i][1], m->value);
    }
}

/* How many frames the cases have, and of how many a cap ended the rounds. */
static void note_frames(struct rl_claim *c, const struct rl_fps_costs *k, const char *model)
{
    const struct rl_metric *frames = rl_fps_model_metric(k, model, "frames");
    const struct rl_metric *points = rl_fps_model_metric(k, model, "points");
    const struct rl_metric *capped = rl_fps_model_metric(k, model, "capped");
    if (frames && points && capped && capped->value > 0.0)
        add(c, "; %.0f frames or more, a cap came before 2 %% in %.0f of %.0f cases", frames->value,
            capped->value, points->value);
    else if (frames)
        add(c, "; %.0f frames or more", frames->value);
}

void rl_fps_note_refusal(struct rl_claim *c, const struct rl_fps_costs *k, const char *model)
{
    const struct rl_metric *refusal = rl_fps_model_metric(k, model, "refusal");
    if (!refusal)
        return;
    const struct rl_metric *ms = rl_fps_model_metric(k, model, "refused_ms");
    const struct rl_metric *points = rl_fps_model_metric(k, model, "points");
    add(c, "%sno fit of %s: ", c->note[0] ? "; " : "", model);
    switch ((enum rl_fit_refusal)refusal->value) {
    case RL_FIT_FEW_POINTS:
        add(c, "%.0f cases are no more than it has terms", points ? points->value : 0.0);
        break;
    case RL_FIT_NOT_POSITIVE:
        add(c, "a median of %.3g ms, not above 0, at", ms ? ms->value : NAN);
        note_case(c, k, model, "refused");
        add(c, " (what it adds is lost in the noise)");
        break;
    case RL_FIT_NOT_FINITE:
        add(c, "no time, or no count of the work, at");
        note_case(c, k, model, "refused");
        break;
    case RL_FIT_DEPENDENT:
        add(c, "the cases measured do not tell its terms apart");
        break;
    default:
        add(c, "it could not be computed");
    }
}

void rl_fps_note_fit(struct rl_claim *c, const struct rl_fps_costs *k, const char *model)
{
    static const char *const term[] = {"constant_ms",      "per_pixel_ns",       "per_drawn_pixel_ns",
                                       "per_sample_ns",    "per_texel_ns",       "per_object_us",
                                       "per_roughness_us", "per_texel_normal_ns"};
    int n = 0;
    for (size_t i = 0; i < sizeof term / sizeof term[0]; i++) {
        const struct rl_metric *m = rl_fps_model_metric(k, model, term[i]);
        const char name[2] = {(char)('a' + n), '\0'};
        rl_fps_note_term(c, m, name);
        n += m != NULL;
    }
    const struct rl_metric *r2 = rl_fps_model_metric(k, model, "r2");
    if (r2) {
        add(c, "; R^2 %.5g; worst:", r2->value);
        note_case(c, k, model, "worst");
    }
    note_frames(c, k, model);
}
