/* Measures the cases of the study `bitdepth` (see bitdepth.h). */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "measure/statistics.h"
#include "studies/bitdepth.h"
#include "studies/timing_arms.h"

/* Where the work on one group stands. */
struct group {
    struct rl_bench *bench;
    const struct rl_scene *scene;
    struct rl_error *error;
    struct rl_bench_scene *set; /* the latest */
    char series[RL_NAME_MAX];   /* of `exact` */
    struct rl_seeds exact;      /* full precision, first of its series */
    struct rl_image surface;    /* without a highlight, once a frame buffer needs it */
    struct rl_interval noise_4; /* of the first record, scaled from its N to 4 */
    bool has_noise;
};

/* Within the series "normals" only the map changes, and the programs are compiled once. */
static int prepare(struct group *g, const struct rl_record *r)
{
    if (!g->set || !rl_parameters_match(r->parameters, "series=normals")) {
        rl_bench_scene_free(g->set);
        return rl_bench_scene_make(&g->set, g->bench, g->scene, r->parameters, 1, g->error);
    }
    char bits[RL_NAME_MAX];
    rl_parameter(r->parameters, "normal_bits", bits, sizeof bits);
    return rl_parse_normal_bits(&g->set->plan.settings.normal_bits, bits, "normal_bits", g->error);
}

static int draw(struct rl_seeds *s, struct group *g, const struct rl_record *r)
{
    if (rl_parameters_match(r->parameters, "series=regular")) {
        s->n = 1;
        return rl_bitdepth_pattern_picture(&s->image[0], g->bench, g->scene, r->parameters, g->error);
    }
    int status = prepare(g, r);
    double seeds = rl_parameter_number(r->parameters, "seeds");
    return status == RL_OK ? rl_seeds_draw(s, g->bench, g->set, seeds, g->error) : status;
}

static struct rl_interval root(double value, double low, double high)
{
    return (struct rl_interval){rl_root(value), rl_root(low), rl_root(high)};
}

/* The worst of both ends; NaN beside nothing. */
static struct rl_interval divide(struct rl_interval a, struct rl_interval b)
{
    if (!(b.value > 0.0))
        return (struct rl_interval){NAN, NAN, NAN};
    return (struct rl_interval){a.value / b.value, a.low / b.high, b.low > 0.0 ? a.high / b.low : INFINITY};
}

static int measure_noise(struct group *g, const struct rl_record *r)
{
    struct rl_bias_variance s;
    int status = rl_seeds_split(&s, &g->exact, NULL, g->error);
    double to_4 = rl_parameter_number(r->parameters, "samples") / 4.0;
    g->noise_4 = root(to_4 * s.variance, to_4 * s.variance_low, to_4 * s.variance_high);
    g->has_noise = true;
    return status;
}

static struct rl_interval over_seeds(const double *value, size_t n)
{
    return n == 1 ? (struct rl_interval){value[0], value[0], value[0]} : rl_mean_interval(value, n, 0.95);
}

/* How `coarse` differs from `exact`, picture by picture. */
static int compare(struct rl_record *r, const struct group *g, const struct rl_seeds *coarse,
                   const struct rl_seeds *exact)
{
    double mean[RL_SEEDS_MAX], square[RL_SEEDS_MAX];
    for (size_t k = 0; k < exact->n; k++) {
        struct rl_metrics m;
        int status = rl_metrics_compute(&m, &coarse->image[k], &exact->image[k], g->error);
        if (status != RL_OK)
            return status;
        mean[k] = m.bias;
        square[k] = m.rmse * m.rmse;
    }
    struct rl_seeds difference = {0};
    struct rl_bias_variance s = {0};
    int status = rl_seeds_difference(&difference, coarse, exact, g->error);
    if (status == RL_OK)
        status = rl_seeds_split(&s, &difference, NULL, g->error);
    rl_seeds_clear(&difference);
    struct rl_interval bias = root(s.bias2, s.bias2_low, s.bias2_high);
    struct rl_interval change = over_seeds(square, exact->n);
    change = root(change.value, change.low, change.high);
    const struct {
        const char *name;
        struct rl_interval x;
    } metric[] = {
        {"bias", bias},
        {"change", change},
        {"difference", over_seeds(mean, exact->n)},
        {"noise_4", g->noise_4},
        {"bias_of_noise", divide(bias, g->noise_4)},
        {"change_of_noise", divide(change, g->noise_4)},
    };
    for (size_t i = 0; i < sizeof metric / sizeof metric[0] && status == RL_OK; i++)
        status = rl_record_add(r, metric[i].name, metric[i].x, "1", g->error);
    return status;
}

static int make_surface(struct group *g, const struct rl_record *r)
{
    char parameters[RL_PARAMETERS_MAX + 16];
    const char *rest = strchr(strstr(r->parameters, "method="), ' ');
    snprintf(parameters, sizeof parameters, "method=none%s", rest);
    return rl_bench_picture(&g->surface, g->bench, g->scene, parameters, 1, g->error);
}

static int measure_frame(struct rl_record *r, struct group *g)
{
    char name[RL_NAME_MAX];
    enum rl_texel_format format;
    struct rl_seeds rounded = {0}, clamped = {0};
    double share = 0.0;
    rl_parameter(r->parameters, "frame_format", name, sizeof name);
    int status = rl_parse_texel_format(&format, name, "frame_format", g->error);
    if (status == RL_OK && !g->surface.data)
        status = make_surface(g, r);
    if (status == RL_OK)
        status = rl_bitdepth_frames(&rounded, &clamped, &share, &g->exact, &g->surface, format, g->error);
    if (status == RL_OK)
        status = compare(r, g, &rounded, &clamped);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "clipped", share, "1", g->error);
    rl_seeds_clear(&rounded);
    rl_seeds_clear(&clamped);
    return status;
}

/* The first of a series is drawn to be kept, and its noise is that of the group if it is the first of all. */
static int begin_series(struct group *g, const struct rl_record *r, const char *series)
{
    rl_seeds_clear(&g->exact);
    snprintf(g->series, sizeof g->series, "%s", series);
    int status = draw(&g->exact, g, r);
    return status == RL_OK && !g->has_noise ? measure_noise(g, r) : status;
}

static int measure_one(struct rl_record *r, struct group *g)
{
    char series[RL_NAME_MAX];
    rl_parameter(r->parameters, "series", series, sizeof series);
    bool first = strcmp(series, g->series) != 0;
    int status = first ? begin_series(g, r, series) : RL_OK;
    if (status != RL_OK)
        return status;
    if (first)
        return compare(r, g, &g->exact, &g->exact);
    if (strcmp(series, "frame") == 0)
        return measure_frame(r, g);
    struct rl_seeds coarse = {0};
    status = draw(&coarse, g, r);
    if (status == RL_OK)
        status = compare(r, g, &coarse, &g->exact);
    rl_seeds_clear(&coarse);
    return status;
}

/* The arms take turns frame by frame; times are relative to the arm of 8 bits. */
static int measure_time(struct rl_record *records, size_t n, struct group *g)
{
    struct rl_bench_scene *set[RL_TIMING_ARMS_MAX] = {NULL};
    struct rl_timing_arm arm[RL_TIMING_ARMS_MAX];
    int status = n <= RL_TIMING_ARMS_MAX
                     ? RL_OK
                     : rl_fail(g->error, RL_ERR_INPUT, "a group of %zu cases, expected at most %d", n,
                               RL_TIMING_ARMS_MAX);
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = rl_bench_scene_make(&set[i], g->bench, g->scene, records[i].parameters, 1, g->error);
        arm[i] = (struct rl_timing_arm){records[i].parameters, rl_arms_frame, set[i]};
    }
    int rounds = (int)rl_parameter_number(records[0].parameters, "rounds");
    const struct rl_arms_options options = {.frames = rounds,
                                            .most_frames = 2 * rounds,
                                            .most_seconds = 0.04 * rounds,
                                            .baseline = "arm=none",
                                            .against = "arm=8",
                                            .ratio = "time_to_8"};
    if (status == RL_OK)
        status = rl_arms_time(records, arm, n, g->bench, &options, g->error);
    for (size_t i = 0; i < n && i < RL_TIMING_ARMS_MAX; i++)
        rl_bench_scene_free(set[i]);
    return status;
}

int rl_bitdepth_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                        const struct rl_scene *scene, struct rl_error *error)
{
    struct group g = {.bench = bench, .scene = scene, .error = error};
    if (rl_parameters_match(records[0].parameters, "series=time"))
        return measure_time(records, n, &g);
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = measure_one(&records[i], &g);
    rl_bench_scene_free(g.set);
    rl_seeds_clear(&g.exact);
    rl_image_clear(&g.surface);
    return status;
}
