/* Cases in memory: what a study measures, one record each, and the run they belong to.
 *
 * A case is named by its study, scene and parameters: text of the form "method=random samples=4 rr=30", always in the same order.
 * Cases of one `group` are measured together (arms of a timing, interleaved) and kept or lost together.
 *
 *     struct rl_record *r = rl_run_add(&run, &place, 0, &error, "method=%s samples=%d", "random", 4);
 *     rl_record_metric_add(r, "rmse", 0.02, 0.019, 0.021, "1", &error);
 *     const struct rl_record *found = rl_run_find(&run, "teapot-star", "samples=4 method=random");
 */
#ifndef RL_RESULTS_RECORD_H
#define RL_RESULTS_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "base/hash.h"
#include "measure/statistics.h"
#include "results/provenance.h"

enum { RL_NAME_MAX = 64, RL_PARAMETERS_MAX = 384, RL_SCENE_PATH_MAX = 512, RL_GRID_MAX = 512 };

enum rl_record_status { RL_RECORD_PLANNED, RL_RECORD_OK, RL_RECORD_FAILED };

/* What reading a figure adds to the mark that a record points at. */
enum { RL_RECORD_READ = 1 };

/* A figure with its 95 % interval; low = high = value where it has none to speak of. Unit "1": a pure number. */
struct rl_metric {
    char name[RL_NAME_MAX], unit[RL_NAME_MAX];
    double value, low, high;
};

/* Raw figures in the order in which they were taken, e.g. the time of every frame. */
struct rl_series {
    char name[RL_NAME_MAX];
    size_t n;
    double *value;
};

struct rl_record {
    char study[RL_NAME_MAX];
    char scene[RL_NAME_MAX];            /* its file's name without folder and ending */
    char scene_path[RL_SCENE_PATH_MAX]; /* as the user gave it */
    char scene_hash[RL_HASH_TEXT];
    char parameters[RL_PARAMETERS_MAX];
    char identity[RL_HASH_TEXT]; /* see rl_run_identify */
    int group;
    enum rl_record_status status;
    char message[512];   /* why it failed; of a measured case a remark that its study made, or "" */
    double seconds;      /* that its group took */
    unsigned char *mark; /* where to note that a figure was read, or NULL (see results/trace.h) */
    size_t n_metrics, n_series;
    struct rl_metric *metric;
    struct rl_series *series;
};

/* The cases of one study, planned together. `provenance` is that of the run, not of each case's measurement; they
 * have the same environment. */
struct rl_run {
    char study[RL_NAME_MAX];
    char grid[RL_GRID_MAX]; /* "quick", "default", "full", then the axes given: "quick --axis rr=1,2" */
    char started[32];       /* UTC, ISO 8601 */
    struct rl_provenance provenance;
    size_t n_records;
    struct rl_record *record;
};

/* A scene as records name it. */
struct rl_place {
    const char *study, *scene, *scene_path;
    uint64_t scene_hash;
};

void rl_run_clear(struct rl_run *run);

/* Adds a planned record and returns it (valid until the next is added), or NULL with `error` filled. */
struct rl_record *rl_run_add(struct rl_run *run, const struct rl_place *place, int group,
                             struct rl_error *error, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/* Gives each record its identity: the hash of study, scene hash, parameters and the environment that measures it
 * (rl_provenance_environment). Same identity, same result: it need not be measured again. */
void rl_run_identify(struct rl_run *run, const char *environment);

/* The hash of study, scene hash and parameters alone: the same case on any machine, by any version. */
uint64_t rl_record_key(const struct rl_record *record);

/* The first measured record (RL_RECORD_OK) of that scene (NULL: any) whose parameters hold every "key=value" of `pattern`,
 * after `after` (NULL: from the start); NULL if there is none. */
const struct rl_record *rl_run_next(const struct rl_run *run, const struct rl_record *after,
                                    const char *scene, const char *pattern);
const struct rl_record *rl_run_find(const struct rl_run *run, const char *scene, const char *pattern);

/* How many records have that status. */
size_t rl_run_count(const struct rl_run *run, enum rl_record_status status);

bool rl_parameters_match(const char *parameters, const char *pattern);
/* Copies the value of `key`; false (and "") if there is none. */
bool rl_parameter(const char *parameters, const char *key, char *value, size_t size);
/* The value as a number, NaN if there is none. */
double rl_parameter_number(const char *parameters, const char *key);

int rl_record_metric_add(struct rl_record *record, const char *name, double value, double low, double high,
                         const char *unit, struct rl_error *error);
/* The same, value and interval in one. */
int rl_record_add(struct rl_record *record, const char *name, struct rl_interval x, const char *unit,
                  struct rl_error *error);
/* The same of a value without error. */
int rl_record_add_exact(struct rl_record *record, const char *name, double value, const char *unit,
                        struct rl_error *error);
/* Copies n values. */
int rl_record_series_add(struct rl_record *record, const char *name, const double *value, size_t n,
                         struct rl_error *error);

/* Whether a metric depends on the clock, so that no two measurements of a case agree in it: its unit is one of time ("ms", "s", "1/s"),
 * or it is a ratio of times ("time_...", "1") or the number of frames timed ("frames"). */
bool rl_metric_timed(const struct rl_metric *metric);

/* NULL if absent. Either notes that the record was read. */
const struct rl_metric *rl_record_metric(const struct rl_record *record, const char *name);
const struct rl_series *rl_record_series(const struct rl_record *record, const char *name);

/* Frees metrics and series; what names the case stays. */
void rl_record_reset(struct rl_record *record);

#endif
