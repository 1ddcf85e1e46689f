/* Which object and triangle each pixel shows (see gpu.h): the surface pass over again with a program that writes numbers. */
#include "gpu/scene.h"

enum { FLOAT_COUNTS_TO = 1 << 24 };

static int check_counts(const struct rl_gpu_scene *gs, struct rl_error *error)
{
    for (size_t i = 0; i < gs->scene->n_objects; i++)
        if (gs->scene->object[i].mesh.n_triangles > FLOAT_COUNTS_TO)
            return rl_fail(error, RL_ERR_INPUT, "object %zu: %zu triangles, expected at most %d", i,
                           gs->scene->object[i].mesh.n_triangles, (int)FLOAT_COUNTS_TO);
    return RL_OK;
}

/* A plan with that program and nothing else of its own. */
static int make_program(struct rl_gpu_program *p, const struct rl_gpu_scene *gs, struct rl_error *error)
{
    struct rl_plan_program program = {.pass = "identity"};
    struct rl_plan plan = *gs->plan;
    rl_plan_add_module(&program, "passes/object_vertex");
    program.n_vertex = program.n_modules;
    rl_plan_add_module(&program, "passes/identity");
    plan.program = &program;
    plan.n_programs = 1;
    plan.n_materials = 0;
    return rl_program_make(p, gs->gpu, &plan, 0, gs->scene, error);
}

static int draw(struct rl_gpu_scene *gs, struct rl_error *error)
{
    struct rl_gl *gl = &gs->gpu->gl;
    struct rl_gpu_program p;
    int status = make_program(&p, gs, error);
    if (status != RL_OK)
        return status;
    const struct rl_gpu_counters before = gs->counters;
    GLint number = gl->GetUniformLocation(p.id, "object_number");
    rl_frame_begin(gs);
    gl->UseProgram(p.id);
    rl_frame_set_camera(gs, &p);
    for (size_t i = 0; i < gs->scene->n_objects; i++)
        if (gs->plan->object[i].drawn) {
            gl->Uniform1f(number, (float)(i + 1));
            rl_frame_draw_mesh(gs, &gs->object[i]);
        }
    gl->Finish();
    gs->counters = before;
    rl_program_free(&p, gs->gpu);
    return rl_gl_check(gl, "drawing identities", error);
}

int rl_gpu_scene_read_identity(struct rl_gpu_scene *gs, struct rl_image *image, struct rl_error *error)
{
    struct rl_image colours = {0};
    int status = check_counts(gs, error);
    if (status == RL_OK)
        status = draw(gs, error);
    if (status == RL_OK)
        status = rl_gpu_scene_read(gs, &colours, error);
    if (status == RL_OK)
        status = rl_image_allocate(image, gs->width, gs->height, 2, error);
    for (size_t i = 0; i < (size_t)gs->width * (size_t)gs->height && status == RL_OK; i++)
        for (size_t c = 0; c < 2; c++)
            image->data[2 * i + c] = colours.data[4 * i + c];
    rl_image_clear(&colours);
    return status;
}
