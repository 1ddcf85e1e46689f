/* Cost models of the study `fps`: what a frame's time is made of, by least squares over the cases of a series (see fps.h).
 *
 * Relative residuals count, since frames jitter in proportion to their time. Intervals come from drawing the rounds again, whole
 * rounds at a time: arms of a round share its slow spells (measure/fit.h). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "measure/fit.h"
#include "studies/fps.h"

enum { POINTS_MAX = 256, RESAMPLES = 500, TERMS_MAX = 3 };

enum term { CONSTANT, PIXELS, DRAWN, SAMPLES, TEXELS, OBJECTS, ROUGHNESSES, TEXEL_NORMALS };

/* A coefficient is in ms per unit of its term; as a metric it is `scale` times that. */
static const struct {
    const char *metric, *unit;
    double scale;
} terms[] = {
    [CONSTANT] = {"constant_ms", "ms", 1.0},         [PIXELS] = {"per_pixel_ns", "ns", 1e6},
    [DRAWN] = {"per_drawn_pixel_ns", "ns", 1e6},     [SAMPLES] = {"per_sample_ns", "ns", 1e6},
    [TEXELS] = {"per_texel_ns", "ns", 1e6},          [OBJECTS] = {"per_object_us", "us", 1e3},
    [ROUGHNESSES] = {"per_roughness_us", "us", 1e3}, [TEXEL_NORMALS] = {"per_texel_normal_ns", "ns", 1e6},
};

/* `arms` of a series; `above`: less the frame without highlight. */
static const struct model {
    const char *name, *series, *arms;
    bool above;
    int n_terms;
    enum term term[TERMS_MAX];
} models[] = {
    {"none", "size", "none", false, 2, {CONSTANT, PIXELS}},
    {"plain", "size", "plain", true, 2, {CONSTANT, PIXELS}},
    {"random", "size", "random-1,random-4,random-16", true, 2, {CONSTANT, SAMPLES}},
    {"random-pixels", "size", "random-1,random-4,random-16", true, 3, {CONSTANT, DRAWN, SAMPLES}},
    {"regular", "size", "regular-4,regular-13,regular-25", true, 2, {CONSTANT, SAMPLES}},
    {"regular-pixels", "size", "regular-4,regular-13,regular-25", true, 3, {CONSTANT, DRAWN, SAMPLES}},
    {"environment-pass", "environment", "environment", false, 2, {CONSTANT, TEXELS}},
    {"environment-frame", "environment", "random-4", true, 2, {CONSTANT, TEXELS}},
    {"objects-none", "objects", "none", false, 2, {CONSTANT, OBJECTS}},
    {"objects-frame", "objects", "random-4", true, 2, {SAMPLES, OBJECTS}},
    {"objects-pass", "objects", "environment", false, 2, {CONSTANT, OBJECTS}},
    {"roughness-frame", "roughness", "random-4", true, 2, {CONSTANT, ROUGHNESSES}},
    {"roughness-margin", "roughness", "random-4-margin", true, 2, {CONSTANT, ROUGHNESSES}},
    {"maps", "maps", "normal-maps", false, 2, {CONSTANT, ROUGHNESSES}},
    {"exhaustive", "exhaustive", "exhaustive", false, 3, {CONSTANT, DRAWN, TEXEL_NORMALS}},
};

static const struct rl_column columns[] = {
    {"scene", RL_COLUMN_SCENE, NULL},
    {"model", RL_COLUMN_TEXT, "model"},
    {"series", RL_COLUMN_TEXT, "series"},
    {"arms", RL_COLUMN_TEXT, "arms"},
    {"quantity", RL_COLUMN_TEXT, "quantity"},
    {"points", RL_COLUMN_VALUE, "points"},
    {"frames", RL_COLUMN_VALUE, "frames"},
    {"capped", RL_COLUMN_VALUE, "capped"},
    RL_COLUMNS_WITH_INTERVAL("constant_ms"),
    RL_COLUMNS_WITH_INTERVAL("per_pixel_ns"),
    RL_COLUMNS_WITH_INTERVAL("per_drawn_pixel_ns"),
    RL_COLUMNS_WITH_INTERVAL("per_sample_ns"),
    RL_COLUMNS_WITH_INTERVAL("per_texel_ns"),
    RL_COLUMNS_WITH_INTERVAL("per_object_us"),
    RL_COLUMNS_WITH_INTERVAL("per_roughness_us"),
    RL_COLUMNS_WITH_INTERVAL("per_texel_normal_ns"),
    {"r2", RL_COLUMN_VALUE, "r2"},
    {"residual", RL_COLUMN_VALUE, "residual"},
    RL_COLUMNS_WITH_INTERVAL("worst_residual"),
    {"worst_width_px", RL_COLUMN_VALUE, "worst_width"},
    {"worst_samples", RL_COLUMN_VALUE, "worst_samples"},
    {"worst_env_size_px", RL_COLUMN_VALUE, "worst_env_size"},
    {"worst_objects", RL_COLUMN_VALUE, "worst_objects"},
    {"worst_roughnesses", RL_COLUMN_VALUE, "worst_roughnesses"},
    {"noise_floor", RL_COLUMN_VALUE, "noise_floor"},
    {"scene_hash", RL_COLUMN_SCENE_HASH, NULL},
};

const struct rl_table rl_fps_model_table = {
    "fps_models",
    "Cost models, fitted by least squares to the medians, relative residuals; intervals from drawing the "
    "rounds again; and where each fails most",
    "",
    columns,
    sizeof columns / sizeof columns[0],
};

static bool same(const struct rl_record *a, const struct rl_record *b, const char *key)
{
    double x = rl_parameter_number(a->parameters, key), y = rl_parameter_number(b->parameters, key);
    return x == y || (isnan(x) && isnan(y));
}

long rl_fps_arm(const struct rl_record *records, size_t n, const struct rl_record *like, const char *name)
{
    char pattern[64];
    snprintf(pattern, sizeof pattern, "arm=%s", name);
    long found = -1;
    int most = -1;
    for (size_t i = 0; i < n; i++) {
        const struct rl_record *r = &records[i];
        if (r->group != like->group || !rl_parameters_match(r->parameters, pattern) ||
            !same(r, like, "width") || !same(r, like, "height") || !same(r, like, "objects"))
            continue;
        int common = same(r, like, "roughnesses") + same(r, like, "env_size");
        if (common > most) {
            found = (long)i;
            most = common;
        }
    }
    return found;
}

static double metric(const struct rl_record *r, const char *name)
{
    const struct rl_metric *m = rl_record_metric(r, name);
    return m ? m->value : NAN;
}

static double value_of(const struct rl_record *r, enum term term)
{
    const char *p = r->parameters;
    double edge = rl_parameter_number(p, "env_size");
    switch (term) {
    case CONSTANT:
        return 1.0;
    case PIXELS:
        return rl_parameter_number(p, "width") * rl_parameter_number(p, "height");
    case DRAWN:
        return metric(r, "drawn_px");
    case SAMPLES:
        return metric(r, "drawn_px") * rl_parameter_number(p, "samples");
    case TEXELS:
        return 6.0 * edge * edge * metric(r, "env_maps");
    case OBJECTS:
        return rl_parameter_number(p, "objects");
    case ROUGHNESSES:
        return rl_parameter_number(p, "roughnesses");
    case TEXEL_NORMALS:
        return metric(r, "texel_normals");
    }
    return NAN;
}

/* The cases of one model. */
struct cases {
    size_t n;
    const struct rl_record *record[POINTS_MAX];
    struct rl_fit_point point[POINTS_MAX];
};

static bool has_arm(const struct model *m, const struct rl_record *r)
{
    char arm[RL_NAME_MAX], series[RL_NAME_MAX];
    rl_parameter(r->parameters, "series", series, sizeof series);
    if (strcmp(series, m->series) != 0 || !rl_parameter(r->parameters, "arm", arm, sizeof arm))
        return false;
    size_t length = strlen(arm);
    for (const char *at = m->arms; *at; at += strspn(at, ",")) {
        size_t word = strcspn(at, ",");
        if (word == length && strncmp(at, arm, word) == 0)
            return true;
        at += word;
    }
    return false;
}

/* More roughnesses than there are objects otherwise take more objects, which have their own price. */
static bool more_objects(const struct rl_record *r)
{
    return rl_parameters_match(r->parameters, "series=roughness") &&
           rl_parameter_number(r->parameters, "roughnesses") > RL_FPS_OBJECTS;
}

static void collect(struct cases *c, const struct model *m, const struct rl_run *run, const char *scene)
{
    c->n = 0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(run, r, scene, "")) && c->n < POINTS_MAX;) {
        const struct rl_series *time =
            has_arm(m, r) && !more_objects(r) ? rl_record_series(r, "frame_ms") : NULL;
        if (!time)
            continue;
        struct rl_fit_point p = {.sample = time->value, .n = time->n, .block = r->group};
        if (m->above) {
            long none = rl_fps_arm(run->record, run->n_records, r, "none");
            bool measured = none >= 0 && run->record[none].status == RL_RECORD_OK;
            const struct rl_series *base = measured ? rl_record_series(&run->record[none], "frame_ms") : NULL;
            if (!base || base->n != time->n)
                continue;
            p.minus = base->value;
        }
        for (int k = 0; k < m->n_terms; k++)
            p.x[k] = value_of(r, m->term[k]);
        c->record[c->n] = r;
        c->point[c->n++] = p;
    }
}

/* How far apart the two arms of the same work are, at most; NaN: not measured. */
static double noise_floor_of(const struct rl_run *run, const char *scene, const char *series)
{
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=%s arm=random-4-again", series);
    const struct rl_record *again = rl_run_find(run, scene, pattern);
    const struct rl_metric *times = again ? rl_record_metric(again, "time_to_random4") : NULL;
    return times ? fmax(times->high - 1.0, 1.0 - times->low) : NAN;
}

/* In the same series, or else in Table 1. */
static double noise_floor(const struct rl_run *run, const char *scene, const char *series)
{
    double here = noise_floor_of(run, scene, series);
    return isnan(here) ? noise_floor_of(run, scene, "table1") : here;
}

static int add_number(struct rl_record *r, const char *name, double x, const char *unit,
                      struct rl_error *error)
{
    return isnan(x) ? RL_OK : rl_record_add_exact(r, name, x, unit, error);
}

static int add_interval(struct rl_record *r, const char *name, struct rl_interval x, double scale,
                        const char *unit, struct rl_error *error)
{
    return isnan(x.value)
               ? RL_OK
               : rl_record_metric_add(r, name, scale * x.value, scale * x.low, scale * x.high, unit, error);
}

/* The case that the model describes worst, or ("refused") the one that it cannot be fitted to. */
static int add_case(struct rl_record *r, const char *which, const struct rl_record *at,
                    struct rl_error *error)
{
    static const char *const key[] = {"width", "samples", "env_size", "objects", "roughnesses"};
    int status = RL_OK;
    for (size_t i = 0; i < sizeof key / sizeof key[0] && status == RL_OK; i++) {
        char name[RL_NAME_MAX];
        snprintf(name, sizeof name, "%s_%s", which, key[i]);
        status = add_number(r, name, rl_parameter_number(at->parameters, key[i]), "1", error);
    }
    return status;
}

/* Why there is no fit: the reason, and where one case is it, its time and what it is. */
static int add_refusal(struct rl_record *r, const struct cases *c, const struct rl_fit *fit,
                       struct rl_error *error)
{
    int status = add_number(r, "refusal", (double)fit->refusal, "1", error);
    bool one = fit->refusal == RL_FIT_NOT_POSITIVE || fit->refusal == RL_FIT_NOT_FINITE;
    if (status == RL_OK && one)
        status = add_number(r, "refused_ms", fit->refused_y, "ms", error);
    return status == RL_OK && one ? add_case(r, "refused", c->record[fit->refused_point], error) : status;
}

static int add_fit(struct rl_record *r, const struct model *m, const struct cases *c,
                   const struct rl_fit *fit, struct rl_error *error)
{
    double frames = INFINITY, capped = 0.0;
    for (size_t i = 0; i < c->n; i++) {
        frames = fmin(frames, (double)c->point[i].n);
        capped += metric(c->record[i], "time_capped") > 0.0;
    }
    int status = add_number(r, "points", (double)c->n, "1", error);
    if (status == RL_OK && c->n > 0)
        status = add_number(r, "frames", frames, "1", error);
    if (status == RL_OK)
        status = add_number(r, "capped", capped, "1", error);
    if (status == RL_OK && fit->refusal != RL_FIT_DONE)
        status = add_refusal(r, c, fit, error);
    for (int k = 0; k < m->n_terms && status == RL_OK; k++)
        status = add_interval(r, terms[m->term[k]].metric, fit->coefficient[k], terms[m->term[k]].scale,
                              terms[m->term[k]].unit, error);
    if (status == RL_OK)
        status = add_number(r, "r2", fit->r2, "1", error);
    if (status == RL_OK)
        status = add_number(r, "residual", fit->residual, "1", error);
    if (status == RL_OK)
        status = add_interval(r, "worst_residual", fit->worst, 1.0, "1", error);
    return status == RL_OK && !isnan(fit->worst.value)
               ? add_case(r, "worst", c->record[fit->worst_point], error)
               : status;
}

static int add_model(struct rl_run *out, const struct model *m, const struct rl_run *run, const char *scene,
                     struct rl_error *error)
{
    char pattern[64];
    snprintf(pattern, sizeof pattern, "series=%s", m->series);
    const struct rl_record *any = rl_run_find(run, scene, pattern);
    if (!any)
        return RL_OK;
    struct cases c;
    collect(&c, m, run, scene);
    struct rl_fit fit = rl_fit_rounds(c.point, c.n, m->n_terms, 0.95, RESAMPLES, 1);
    struct rl_place place = {run->study, scene, any->scene_path, 0};
    struct rl_record *r = rl_run_add(out, &place, 0, error, "model=%s series=%s arms=%s quantity=%s", m->name,
                                     m->series, m->arms, m->above ? "above_baseline_ms" : "frame_ms");
    if (!r)
        return RL_ERR_SYSTEM;
    memcpy(r->scene_hash, any->scene_hash, sizeof r->scene_hash);
    r->status = RL_RECORD_OK;
    int status = add_fit(r, m, &c, &fit, error);
    return status == RL_OK ? add_number(r, "noise_floor", noise_floor(run, scene, m->series), "1", error)
                           : status;
}

void rl_fps_read_cases(const struct rl_run *run, const char *scene, const char *model)
{
    struct cases c;
    for (size_t m = 0; m < sizeof models / sizeof models[0]; m++)
        if (strcmp(models[m].name, model) == 0)
            collect(&c, &models[m], run, scene);
}

static int add_models(struct rl_run *out, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++)
        for (size_t m = 0; m < sizeof models / sizeof models[0] && status == RL_OK; m++)
            status = add_model(out, &models[m], run, scene, error);
    return status;
}

int rl_fps_derive(struct rl_run *out, const struct rl_run *run, struct rl_error *error)
{
    *out = (struct rl_run){.provenance = run->provenance};
    memcpy(out->study, run->study, sizeof out->study);
    memcpy(out->grid, run->grid, sizeof out->grid);
    /* To fit all models at once is not to read for a claim: the one begun last would come from all cases. */
    struct rl_run unseen = *run;
    unseen.record = malloc((run->n_records + 1) * sizeof *unseen.record);
    if (!unseen.record)
        return rl_fail_memory(error, "the cases of cost models");
    for (size_t i = 0; i < run->n_records; i++) {
        unseen.record[i] = run->record[i];
        unseen.record[i].mark = NULL;
    }
    int status = add_models(out, &unseen, error);
    free(unseen.record);
    if (status != RL_OK)
        rl_run_clear(out);
    return status;
}
