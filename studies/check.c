/* Goes through the cases of the check (see check.h). */
#include "studies/check.h"

#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "studies/check_parts.h"
#include "studies/planner.h"
#include "studies/study.h"

enum { SCENES_MAX = 8 };

struct rl_check {
    struct rl_bench bench;
    const struct rl_progress *progress;
    size_t n_scenes;
    struct rl_scene scene[SCENES_MAX];
    const char *scene_name[SCENES_MAX]; /* the cases' */
    struct rl_scene low[SCENES_MAX];    /* views of `scene` with the eye near the ground */
    struct rl_check_truths truths;
    void **kept; /* rl_n_check_cases */
    struct rl_buffer failures;
};

static void add_row(struct rl_check_rows *rows, const struct rl_baseline_row *row)
{
    if (rows->status == RL_OK)
        rows->status = rl_baseline_add(rows->now, row, rows->error);
}

void rl_check_fixed(struct rl_check_rows *rows, const char *metric, enum rl_best best, double value,
                    double tolerance, const char *tolerance_from, bool drawn)
{
    struct rl_baseline_row row = rows->like;
    row.kind = RL_METRIC_FIXED;
    row.best = best;
    row.mean = (struct rl_mean){value, 0.0, 1};
    row.tolerance = tolerance;
    row.drawn = drawn;
    snprintf(row.metric, sizeof row.metric, "%s", metric);
    snprintf(row.tolerance_from, sizeof row.tolerance_from, "%s", tolerance_from);
    add_row(rows, &row);
}

void rl_check_random(struct rl_check_rows *rows, const char *metric, enum rl_best best, const double value[],
                     size_t n, double relevant)
{
    struct rl_baseline_row row = rows->like;
    row.kind = RL_METRIC_RANDOM;
    row.best = best;
    row.mean = rl_mean_of(value, n);
    row.relevant = relevant;
    row.drawn = true;
    snprintf(row.metric, sizeof row.metric, "%s", metric);
    snprintf(row.tolerance_from, sizeof row.tolerance_from, "-");
    add_row(rows, &row);
}

int rl_check_open(struct rl_check **out, const char *backend, int threads, const struct rl_progress *progress,
                  struct rl_error *error)
{
    *out = NULL;
    struct rl_check *check = calloc(1, sizeof *check);
    void **kept = calloc(rl_n_check_cases, sizeof *kept);
    int status = check && kept ? RL_OK : rl_fail_memory(error, "the check");
    if (status == RL_OK)
        /* References are computed here, from the program that is checked: none is kept in a cache. */
        status = rl_bench_open(&check->bench, backend, threads, NULL, progress, error);
    if (status != RL_OK) {
        free(kept);
        free(check);
        return status;
    }
    check->progress = progress;
    check->kept = kept;
    *out = check;
    return RL_OK;
}

void rl_check_close(struct rl_check *check)
{
    if (!check)
        return;
    for (size_t i = 0; i < rl_n_check_cases; i++)
        if (check->kept[i])
            rl_check_cases[i].release(check->kept[i]);
    for (size_t i = 0; i < check->truths.n; i++)
        rl_image_clear(&check->truths.truth[i].image);
    for (size_t i = 0; i < check->n_scenes; i++)
        rl_scene_clear(&check->scene[i]);
    rl_bench_close(&check->bench);
    rl_buffer_clear(&check->failures);
    free(check->kept);
    free(check);
}

const struct rl_provenance *rl_check_provenance(const struct rl_check *check)
{
    return &check->bench.provenance;
}

const char *rl_check_failures(const struct rl_check *check)
{
    return check->failures.data ? check->failures.data : "";
}

/* From 0.2 above y = 0, level and along -z: a floor is seen at 3 to 11 degrees while lights stand high, so that masking and shadowing
 * differ. From where shipped scenes are seen, both are nearly everywhere 1. */
static struct rl_scene seen_from_low(const struct rl_scene *scene)
{
    struct rl_scene low = *scene;
    low.camera.position = v3(0.0, 0.2, 4.0);
    low.camera.right = v3(1.0, 0.0, 0.0);
    low.camera.up = v3(0.0, 1.0, 0.0);
    low.camera.forward = v3(0.0, 0.0, -1.0);
    low.camera.near_plane = 0.5;
    low.camera.far_plane = 20.0;
    return low;
}

/* NULL for a case without one. */
static int find_scene(const struct rl_scene **scene, struct rl_check *check, const char *name,
                      struct rl_error *error)
{
    *scene = NULL;
    if (strcmp(name, RL_NO_SCENE) == 0)
        return RL_OK;
    for (size_t i = 0; i < check->n_scenes && !*scene; i++)
        if (strcmp(check->scene_name[i], name) == 0)
            *scene = &check->scene[i];
    if (*scene)
        return RL_OK;
    if (check->n_scenes == SCENES_MAX)
        return rl_fail(error, RL_ERR_SYSTEM, "the check has more than %d scenes", SCENES_MAX);
    int status = rl_study_scene_load(&check->scene[check->n_scenes], name, error);
    if (status == RL_OK) {
        check->scene_name[check->n_scenes] = name;
        check->low[check->n_scenes] = seen_from_low(&check->scene[check->n_scenes]);
        *scene = &check->scene[check->n_scenes++];
    }
    return status;
}

static void fill_provenance(struct rl_baseline_row *row, const struct rl_check *check,
                            const struct rl_scene *scene)
{
    const struct rl_provenance *p = &check->bench.provenance;
    snprintf(row->commit, sizeof row->commit, "%s%s", p->commit, p->dirty ? "-modified" : "");
    snprintf(row->renderer, sizeof row->renderer, "%s", p->renderer);
    snprintf(row->scene_hash, sizeof row->scene_hash, "-");
    if (scene)
        rl_hash_text(row->scene_hash, scene->hash);
}

static int measure_case(struct rl_baseline *now, struct rl_check *check, size_t index,
                        const struct rl_check_options *options, struct rl_error *error)
{
    const struct rl_check_case *c = &rl_check_cases[index];
    struct rl_check_context context = {.bench = &check->bench,
                                       .truths = &check->truths,
                                       .options = options,
                                       .first_seed = options->first_seed + ((uint64_t)index << 32),
                                       .kept = &check->kept[index]};
    struct rl_check_rows rows = {.now = now, .error = error};
    double start = rl_clock_seconds();
    size_t first = now->n;
    int status = find_scene(&context.scene, check, c->scene, error);
    if (status != RL_OK)
        return status;
    if (context.scene && rl_parameters_match(c->parameters, "eye=low"))
        context.scene = &check->low[context.scene - check->scene];
    fill_provenance(&rows.like, check, context.scene);
    snprintf(rows.like.scene, sizeof rows.like.scene, "%s", c->scene);
    snprintf(rows.like.parameters, sizeof rows.like.parameters, "%s", c->parameters);
    snprintf(rows.like.unit, sizeof rows.like.unit, "1");
    status = c->measure(&rows, c, &context);
    if (status == RL_OK)
        status = rows.status;
    if (status != RL_OK)
        now->n = first;
    double seconds = rl_clock_seconds() - start;
    for (size_t i = first; i < now->n; i++)
        now->row[i].seconds = seconds;
    return status;
}

/* Errors of a case are kept and do not stop the others, unless they concern all. */
static int go_on(struct rl_check *check, const struct rl_check_case *c, int status, struct rl_error *error)
{
    if (status == RL_OK || status == RL_ERR_CANCELLED || status == RL_ERR_SYSTEM)
        return status;
    rl_buffer_printf(&check->failures, "%s %s: %s\n", c->scene, c->parameters, error->message);
    return rl_buffer_check(&check->failures, error);
}

bool rl_check_wants(const struct rl_check_options *options, const char *scene)
{
    bool wanted = options->n_scenes == 0;
    for (size_t i = 0; i < options->n_scenes && !wanted; i++)
        wanted = strcmp(options->scene[i], scene) == 0;
    return wanted;
}

static bool has_scene(size_t n, const char *scene)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(rl_check_cases[i].scene, scene) == 0)
            return true;
    return false;
}

int rl_check_options_check(const struct rl_check_options *options, struct rl_error *error)
{
    if (options->seeds < 4 || options->seeds > RL_CHECK_SEEDS_MAX || options->seeds % 2)
        return rl_fail(error, RL_ERR_INPUT, "found %zu seeds, expected an even number from 4 to %d",
                       options->seeds, RL_CHECK_SEEDS_MAX);
    for (size_t i = 0; i < options->n_scenes; i++) {
        if (has_scene(rl_n_check_cases, options->scene[i]))
            continue;
        char names[256] = "";
        for (size_t k = 0, used = 0; k < rl_n_check_cases && used < sizeof names; k++)
            if (!has_scene(k, rl_check_cases[k].scene))
                used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "",
                                         rl_check_cases[k].scene);
        return rl_fail(error, RL_ERR_INPUT, "found the scene '%s', expected one of %s", options->scene[i],
                       names);
    }
    return RL_OK;
}

int rl_check_measure(struct rl_baseline *now, struct rl_check *check, const struct rl_check_options *options,
                     struct rl_error *error)
{
    int status = rl_check_options_check(options, error);
    if (status != RL_OK)
        return status;
    struct rl_error own = {0};
    error = error ? error : &own;
    rl_buffer_clear(&check->failures);
    for (size_t i = 0; i < rl_n_check_cases && status == RL_OK; i++) {
        const struct rl_check_case *c = &rl_check_cases[i];
        if (rl_progress_cancelled(check->progress))
            return rl_fail(error, RL_ERR_CANCELLED, "interrupted");
        if ((c->random ? options->random : options->fixed) && rl_check_wants(options, c->scene))
            status = go_on(check, c, measure_case(now, check, i, options, error), error);
        if (status == RL_OK)
            rl_progress_update(check->progress, "check", i + 1, rl_n_check_cases);
    }
    return status;
}
