/* `roughlight study status`: how far each study's latest run is, scene by scene. */
#include <stdlib.h>
#include <string.h>

#include "cli/output.h"
#include "cli/study.h"
#include "results/buffer.h"
#include "results/database.h"

static bool is_of(const struct rl_record *r, const char *scene, enum rl_record_status status)
{
    return r->status == status && strcmp(r->scene, scene) == 0;
}

static long long count(const struct rl_run *run, const char *scene, enum rl_record_status status)
{
    long long n = 0;
    for (size_t i = 0; i < run->n_records; i++)
        n += is_of(&run->record[i], scene, status);
    return n;
}

/* "6: no such method; 2: out of memory": each different message with the number of cases that have it. */
static void add_reasons(struct rl_buffer *text, const struct rl_run *run, const char *scene)
{
    for (size_t i = 0; i < run->n_records; i++) {
        size_t n = 0, before = 0;
        for (size_t k = 0; k < run->n_records && is_of(&run->record[i], scene, RL_RECORD_FAILED); k++) {
            bool same = is_of(&run->record[k], scene, RL_RECORD_FAILED) &&
                        strcmp(run->record[k].message, run->record[i].message) == 0;
            before += same && k < i;
            n += same;
        }
        if (n > 0 && before == 0)
            rl_buffer_printf(text, "%s%zu: %s", text->length ? "; " : "", n, run->record[i].message);
    }
}

static int print_scene(struct rl_rows *rows, const struct rl_run *run, const char *scene,
                       struct rl_error *error)
{
    long long measured = count(run, scene, RL_RECORD_OK), failed = count(run, scene, RL_RECORD_FAILED),
              open = count(run, scene, RL_RECORD_PLANNED);
    struct rl_buffer reasons = {0};
    add_reasons(&reasons, run, scene);
    rl_rows_text(rows, run->study);
    rl_rows_text(rows, run->grid);
    rl_rows_text(rows, run->started);
    rl_rows_integer(rows, measured + failed + open);
    rl_rows_integer(rows, measured);
    rl_rows_integer(rows, failed);
    rl_rows_text(rows, run->provenance.commit);
    rl_rows_text(rows, run->provenance.renderer);
    rl_rows_text(rows, scene);
    rl_rows_integer(rows, open);
    rl_rows_text(rows, reasons.data ? reasons.data : "");
    int status = rl_buffer_check(&reasons, error);
    rl_buffer_clear(&reasons);
    return status;
}

static int print_study(struct rl_rows *rows, const struct rl_run *run, struct rl_error *error)
{
    const char *scene = rl_run_scene(run, 0);
    int status = scene ? RL_OK : print_scene(rows, run, "", error);
    for (size_t i = 0; scene && status == RL_OK; scene = rl_run_scene(run, ++i))
        status = print_scene(rows, run, scene, error);
    return status;
}

/* Every study's latest run, before any is printed: of a damaged file there are no rows. */
static int load_runs(struct rl_run *run, const char *path, struct rl_error *error)
{
    struct rl_database *db;
    int status = rl_database_open(&db, path, RL_DATABASE_READ, error);
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        status = rl_database_load_run(db, rl_studies[i]->name, &run[i], error);
    rl_database_close(db);
    return status;
}

static int print_all(enum rl_output format, const struct rl_run *run, struct rl_error *error)
{
    struct rl_rows rows;
    int status = RL_OK;
    rl_rows_begin(&rows, format,
                  (const char *[]){"study", "grid", "started", "planned", "measured", "failed", "commit",
                                   "renderer", "scene", "open", "reason", NULL});
    for (size_t i = 0; i < rl_n_studies && status == RL_OK; i++)
        status = print_study(&rows, &run[i], error);
    rl_rows_end(&rows);
    return status == RL_OK ? rl_output_check(error) : status;
}

int rl_study_status_command(const struct rl_arguments *a, struct rl_error *error)
{
    enum rl_output format;
    int status = rl_argument_output(a, &format, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    struct rl_run *run = calloc(rl_n_studies, sizeof *run);
    if (!run)
        return rl_exit_of(rl_fail_memory(error, "the studies' runs"));
    status = load_runs(run, rl_study_database(a), error);
    if (status == RL_OK)
        status = print_all(format, run, error);
    for (size_t i = 0; i < rl_n_studies; i++)
        rl_run_clear(&run[i]);
    free(run);
    return rl_exit_of(status);
}
