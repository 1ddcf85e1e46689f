/* The command `probe`: the input is the name of a function in the first line, and rows of its arguments in the others, as it reads them.
 * Rows that it takes are evaluated in C; no result may be NaN. */
#include <math.h>

#include "cli/probe_rows.h"
#include "fuzz/harness.h"

static void evaluate(const struct rl_probe *probe, const struct rl_probe_rows *rows)
{
    double *results = malloc((rows->n * probe->n_out + 1) * sizeof *results);
    FUZZ_CHECK(results);
    rl_probe_cpu(probe, rows->value, rows->n, results);
    for (size_t i = 0; i < rows->n * probe->n_out; i++)
        FUZZ_CHECK(!isnan(results[i]));
    free(results);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = fuzz_text(data, size), *rest = text;
    const char *name = strsep(&rest, "\n");
    struct rl_probe probe;
    struct rl_error error = {0};
    int status = rl_probe_find(&probe, name, &error);
    size_t left = rest ? size - (size_t)(rest - text) : 0;
    FILE *in = status == RL_OK && left > 0 ? fmemopen(rest, left, "r") : NULL;
    if (in) {
        struct rl_probe_rows rows;
        status = rl_probe_rows_read(&rows, &probe, in, "rows", &error);
        if (status == RL_OK)
            evaluate(&probe, &rows);
        rl_probe_rows_clear(&rows);
        fclose(in);
    }
    fuzz_check_error(status, &error);
    free(text);
    return 0;
}
