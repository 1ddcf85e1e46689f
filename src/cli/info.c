/* `info`: what this program is and what this machine offers it. */
#include <stdio.h>
#include <string.h>

#include "base/machine.h"
#include "base/simd.h"
#include "base/version.h"
#include "cli/command.h"
#include "cli/output.h"
#include "gpu/gpu.h"
#include "image/image.h"
#include "reference/renderer.h"

static void row(struct rl_rows *rows, const char *name, const char *value)
{
    rl_rows_text(rows, name);
    rl_rows_text(rows, value);
}

static void backend_row(struct rl_rows *rows, const char *backend)
{
    char name[64];
    char text[1200];
    struct rl_error reason;
    struct rl_gpu *gpu = NULL;
    snprintf(name, sizeof name, "backend %s", backend);
    if (rl_gpu_open(&gpu, backend, &reason) == RL_OK) {
        const struct rl_gpu_info *info = rl_gpu_describe(gpu);
        snprintf(text, sizeof text, "%s; OpenGL %s; %s", info->renderer, info->version, info->vendor);
        rl_gpu_close(gpu);
    } else {
        snprintf(text, sizeof text, "rejected: %s", reason.message);
    }
    row(rows, name, text);
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    enum rl_output format;
    int status = rl_argument_output(a, &format, error);
    if (status != RL_OK)
        return rl_exit_of(status);
    char text[256];
    struct rl_error reason;
    struct rl_rows rows;
    rl_rows_begin(&rows, format, (const char *const[]){"name", "value", NULL});
    row(&rows, "version", rl_version.version);
    snprintf(text, sizeof text, "%s%s", rl_version.commit, rl_version.dirty ? " (modified)" : "");
    row(&rows, "commit", text);
    row(&rows, "compiler", rl_version.compiler);
    row(&rows, "flags", rl_version.cflags);
    rl_machine_cpu(text, sizeof text);
    row(&rows, "cpu", text);
    snprintf(text, sizeof text, "%d", rl_machine_threads());
    row(&rows, "threads", text);
    row(&rows, "simd", rl_simd_name(rl_simd_best()));
    rl_machine_system(text, sizeof text);
    row(&rows, "system", text);
    rl_reference_library(text);
    row(&rows, "embree", text);
    row(&rows, "openimageio", rl_image_library(text, &reason) == RL_OK ? text : reason.message);
    for (size_t i = 0; i < rl_n_gpu_backends; i++)
        backend_row(&rows, rl_gpu_backends[i]);
    rl_rows_end(&rows);
    return RL_EXIT_OK;
}

const struct rl_command rl_command_info = {
    .name = "info",
    .arguments = "[--format tsv|json]",
    .summary = "versions, CPU, libraries, and each GPU backend or why it was rejected",
    .description = "Prints name and value, a row each. A backend that cannot be used says why.\n\n"
                   "  roughlight info\n"
                   "  roughlight info --format json",
    .options = (const struct rl_option *const[]){rl_options_format, NULL},
    .run = run,
};
