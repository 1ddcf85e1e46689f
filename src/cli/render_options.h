/* The options that say how to render, shared by `render` and `plan`. */
#ifndef RL_CLI_RENDER_OPTIONS_H
#define RL_CLI_RENDER_OPTIONS_H

#include "base/error.h"
#include "cli/command.h"
#include "methods/method.h"
#include "scene/scene.h"

extern const struct rl_option rl_options_render[];
/* --backend and --threads */
extern const struct rl_option rl_options_machine[];

/* Overrides what was given; the rest of *settings stays (the scene's defaults). Ranges are checked. */
int rl_argument_settings(struct rl_settings *settings, const struct rl_arguments *arguments,
                         struct rl_error *error);

/* RL_ERR_INPUT: an option was given of which no method of the scene, or of `settings`, makes any use. */
int rl_argument_check_effect(const struct rl_arguments *arguments, const struct rl_scene *scene,
                             const struct rl_settings *settings, struct rl_error *error);

/* Whether a method computes the integral itself, and so states an error. */
bool rl_method_integrates(const struct rl_method *method);

/* --backend, else ROUGHLIGHT_BACKEND, else "auto". */
const char *rl_argument_backend(const struct rl_arguments *arguments);
/* ROUGHLIGHT_BACKEND, else "auto". */
const char *rl_environment_backend(void);

/* --threads, else ROUGHLIGHT_THREADS, else 0: as many as the process may use. A number is passed on to Mesa's software renderer
 * as LP_NUM_THREADS, which it reads when the first context is opened, unless that variable is set already. */
int rl_argument_threads(const struct rl_arguments *arguments, int *threads, struct rl_error *error);

#endif
