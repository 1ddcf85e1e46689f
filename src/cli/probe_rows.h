/* The rows of arguments that `probe` reads: numbers with tabs or blanks between them, a row a line.
 *
 *     struct rl_probe_rows rows;
 *     status = rl_probe_rows_read(&rows, &probe, stdin, "standard input", &error);
 *     if (status == RL_OK)
 *         rl_probe_cpu(&probe, rows.value, rows.n, results);
 *     rl_probe_rows_clear(&rows);
 */
#ifndef RL_CLI_PROBE_ROWS_H
#define RL_CLI_PROBE_ROWS_H

#include <stddef.h>
#include <stdio.h>

#include "base/error.h"
#include "probe/probe.h"

struct rl_probe_rows {
    size_t n, room;
    double *value; /* n rows of probe->n_in */
};

/* Empty lines count as lines and are no rows; the first other line may be the header. RL_ERR_INPUT: "NAME:LINE: COLUMN: found ..., expected
 * ...". Clear the rows, also after an error. */
int rl_probe_rows_read(struct rl_probe_rows *rows, const struct rl_probe *probe, FILE *in, const char *name,
                       struct rl_error *error);
void rl_probe_rows_clear(struct rl_probe_rows *rows);

#endif
