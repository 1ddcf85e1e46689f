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

#include "base/error.h"

enum { RL_PLOT_ARGUMENTS_MAX = 8 };

/* `script` is a file of the folder plots/. RL_ERR_UNAVAILABLE: there is no gnuplot on the PATH. RL_ERR_CHECK: the script
 * found nothing to draw (it says so with `exit status 3`). RL_ERR_SYSTEM: it failed; the message holds gnuplot's own last line. */
int rl_plot(const char *script, const char *const arguments[], struct rl_error *error);

#endif
