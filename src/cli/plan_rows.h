/* Rows of `plan`, shared by the files that print them. */
#ifndef RL_CLI_PLAN_ROWS_H
#define RL_CLI_PLAN_ROWS_H

#include "base/error.h"
#include "cli/output.h"
#include "scene/plan.h"

struct rl_plan_rows {
    struct rl_rows rows;
    const struct rl_scene *scene;
    const struct rl_plan *plan;
};

/* A row as text; what comes back takes the same as keys and values of JSON, and is NULL where no JSON is asked for. */
struct rl_json *rl_plan_row(struct rl_plan_rows *p, const char *kind, const char *name, const char *detail);

/* Textures, then buffers of all kinds (plan_resources.c). RL_ERR_MEMORY. */
void rl_plan_texture_rows(struct rl_plan_rows *p);
int rl_plan_buffer_rows(struct rl_plan_rows *p, struct rl_error *error);

#endif
