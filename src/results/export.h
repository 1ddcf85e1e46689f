/* Tables out of the results: as TSV or CSV with a header row, or as an array of objects of JSON.
 *
 *     rl_export_begin(&table, &text, RL_EXPORT_TSV, columns, n);
 *     rl_export_text(&table, "random"); rl_export_number(&table, 4);     a row is complete with its last column
 *     rl_export_end(&table);
 *
 * Numbers read back as the same double; "nan" stands for what was not measured (null in JSON). A tab or line end inside a text
 * becomes a blank in TSV; CSV is as RFC 4180 has it, and quotes what has a comma, a quote or a line end. A study says with rl_table how its records become rows; columns of such tables are part of the interface:
 * add some, never rename one.
 */
#ifndef RL_RESULTS_EXPORT_H
#define RL_RESULTS_EXPORT_H

#include <stddef.h>

#include "results/buffer.h"
#include "results/record.h"

enum rl_export_format { RL_EXPORT_TSV, RL_EXPORT_JSON, RL_EXPORT_CSV };

struct rl_export {
    struct rl_buffer *out;
    enum rl_export_format format;
    const char *const *column;
    size_t n_columns, next, n_rows;
};

void rl_export_begin(struct rl_export *table, struct rl_buffer *out, enum rl_export_format format,
                     const char *const column[], size_t n_columns);
void rl_export_text(struct rl_export *table, const char *value);
void rl_export_number(struct rl_export *table, double value);
void rl_export_end(struct rl_export *table);

/* Where a column's values come from. */
enum rl_column_source {
    RL_COLUMN_SCENE,
    RL_COLUMN_SCENE_HASH,
    RL_COLUMN_TEXT,   /* the parameter `key` as it is written */
    RL_COLUMN_NUMBER, /* the parameter `key` as a number */
    RL_COLUMN_REMARK, /* the record's remark (record.h) */
    RL_COLUMN_VALUE,  /* the metric `key` */
    RL_COLUMN_LOW,    /* the lower end of its interval */
    RL_COLUMN_HIGH
};

struct rl_column {
    const char *name; /* with its unit, e.g. "frame_ms" */
    enum rl_column_source source;
    const char *key;
};

/* Three columns of one metric: NAME, NAME_low and NAME_high. */
/* clang-format off */
#define RL_COLUMNS_WITH_INTERVAL(name) \
    {name, RL_COLUMN_VALUE, name}, {name "_low", RL_COLUMN_LOW, name}, {name "_high", RL_COLUMN_HIGH, name}
/* clang-format on */

enum { RL_TABLE_COLUMNS_MAX = 64, RL_COLUMN_TEXT_MAX = 512 };

/* The last column of every table of records: the case's identity (results/record.h), by which claims name their cases. */
extern const char rl_identity_column[];

/* Every measured record whose parameters match `pattern` is a row: the columns given, then its identity. */
struct rl_table {
    const char *name;    /* of the file, without its ending */
    const char *summary; /* what it holds, one line */
    const char *pattern;
    const struct rl_column *column;
    size_t n_columns;
};

void rl_export_run(struct rl_buffer *out, const struct rl_table *table, const struct rl_run *run,
                   enum rl_export_format format);

/* Raw samples of every record of the runs: columns study, scene, parameters, series, index, value, identity. */
void rl_export_samples(struct rl_buffer *out, const struct rl_run *runs, size_t n_runs,
                       enum rl_export_format format);

/* A column's value in a record, as a text ready to be printed; RL_COLUMN_TEXT_MAX bytes hold any. */
void rl_column_text(char text[], size_t size, const struct rl_column *column, const struct rl_record *record);

/* ".tsv", ".json" or ".csv" */
const char *rl_export_ending(enum rl_export_format format);

#endif
