/* Figures by gnuplot, started as a process of its own, without a shell.
 *
 *     const char *arguments[] = {"build/report", "build/report/samples-error.svg", "error", NULL};
 *     rl_plot("samples.gp", arguments, &error);
 *
 * The script gets its own style file first: ARG1 is plots/style.gp, ARG2 and on are the arguments. The ending of the output
 * file, by convention ARG3, decides between svg and png.
 */
#ifndef RL_RESULTS_PLOT_H
#define RL_RESULTS_PLOT_H

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "base/progress.h"

enum { RL_PLOT_ARGUMENTS_MAX = 8 };

/* `script` is a file of the folder plots/. RL_ERR_UNAVAILABLE: there is no gnuplot on the PATH. RL_ERR_CHECK: the script
 * found nothing to draw (it says so with `exit status 3`). RL_ERR_SYSTEM: it failed; the message holds gnuplot's own last line. */
int rl_plot(const char *script, const char *const arguments[], struct rl_error *error);

/* A figure that a study's script draws: as STEM.svg, STEM.png and, small and without words, STEM.small.png. */
struct rl_plot_figure {
    char script[80];     /* "samples.gp", a file of the folder plots/ */
    char stem[PATH_MAX]; /* the files' path without their endings */
    const char *tables;  /* folder that holds them */
    const char *name, *scene;
    bool missing; /* set if there was nothing to draw: no file is left then */
};

/* Draws n figures, as many at once as there are threads (0: as this process may run). Stops at the first that fails for another reason
 * than that there is nothing to draw, and when `progress` is cancelled (RL_ERR_CANCELLED). */
int rl_plot_figures(struct rl_plot_figure *figures, size_t n, int threads, const struct rl_progress *progress,
                    struct rl_error *error);

#endif
