/* Rows on stdout: TSV with a header row, or a JSON array of objects.
 *
 *     struct rl_rows rows;
 *     rl_rows_begin(&rows, RL_OUTPUT_TSV, (const char *[]){"value", "error", NULL});
 *     rl_rows_number(&rows, 0.25); rl_rows_number(&rows, 1e-9);      a row is complete with its last column
 *     rl_rows_end(&rows);
 *
 * Numbers are printed so that reading them back gives the same double. JSON has no NaN or infinity: they become null.
 */
#ifndef RL_CLI_OUTPUT_H
#define RL_CLI_OUTPUT_H

#include <stddef.h>

#include "base/error.h"
#include "cli/command.h"
#include "cli/json.h"

enum rl_output { RL_OUTPUT_TSV, RL_OUTPUT_JSON };

/* The option every command with rows takes; for its list of options. */
extern const struct rl_option rl_options_format[];

struct rl_rows {
    enum rl_output format;
    const char *const *column;
    size_t n_columns, next, n_rows;
    struct rl_json json; /* of the last row, which is open until the next begins */
};

/* --format tsv|json; tsv if absent. */
int rl_argument_output(const struct rl_arguments *arguments, enum rl_output *format, struct rl_error *error);

/* `columns` ends with NULL and must outlive the rows. */
void rl_rows_begin(struct rl_rows *rows, enum rl_output format, const char *const columns[]);
void rl_rows_number(struct rl_rows *rows, double value);
void rl_rows_integer(struct rl_rows *rows, long long value);
void rl_rows_text(struct rl_rows *rows, const char *value);
void rl_rows_end(struct rl_rows *rows);

/* After a row's last column: to add to that row what has no column, keys of its own. NULL in TSV, which has columns alone. */
struct rl_json *rl_rows_more(struct rl_rows *rows);

/* RL_ERR_SYSTEM if anything printed on stdout so far was lost (a full disk, a closed pipe). */
int rl_output_check(struct rl_error *error);

/* Before long work whose result goes into a file: RL_ERR_SYSTEM if `path` cannot be written. Nothing is left behind, and what is there
 * stays. */
int rl_output_file_check(const char *path, struct rl_error *error);

#endif
