/* Sets the CPU renderer up (see render_job.h). */
#include "reference/render_job.h"

#include <stdlib.h>

#include "model/plane.h"

static void make_shader(struct rl_render_shader *s, const struct rl_scene *scene,
                        const struct rl_plan_material *m)
{
    s->plan = m;
    s->material = &scene->material[m->material];
    s->ellipsoid = rl_ellipsoid_make(m->rr);
    for (size_t i = 0; i < m->n_effects; i++)
        m->effect[i]->pack(rl_effect_given(s->material, m->effect[i]), s->effect_params[i]);
    s->integrates = m->method && !m->method->shade;
    if (m->method && m->method->pack)
        m->method->pack(&s->ellipsoid, s->method_params);
}

void rl_render_job_clear(struct rl_render_job *job)
{
    for (int i = 0; i < job->n_views; i++)
        rl_occluders_view_clear(&job->view[i]);
    free(job->view);
    for (int i = 0; i < job->n_views && job->shadow_view; i++)
        rl_shadows_view_clear(&job->shadow_view[i]);
    free(job->shadow_view);
    rl_shadows_free(job->shadows);
    rl_occluders_free(job->occluders);
    rl_shadow_rays_free(job->rays);
    rl_visible_free(job->visible);
    rl_light_set_free(job->lights);
    rl_scene_lights_clear(&job->seen);
    free(job->source);
    free(job->shader);
    free(job->reached);
    for (size_t i = 0; i < job->plan->n_environments && job->environment; i++)
        rl_texel_map_free(job->environment[i]);
    free(job->environment);
    for (size_t i = 0; i < job->scene->n_objects && job->interpolated; i++)
        rl_interpolated_clear(&job->interpolated[i]);
    free(job->interpolated);
}

/* Those that the plan keeps. The sum over them goes in the scene's order. */
static int make_lights(struct rl_render_job *job, struct rl_error *error)
{
    const struct rl_scene *scene = job->scene;
    const struct rl_plan *plan = job->plan;
    int status = rl_plan_lights_make(&job->seen, plan, scene, error);
    if (status != RL_OK)
        return status;
    job->source = calloc(plan->n_sources + 1, sizeof *job->source);
    if (!job->source)
        return rl_fail_memory(error, "the lights");
    for (size_t i = 0; i < scene->n_sources; i++)
        for (size_t k = 0; k < plan->n_sources; k++)
            if (plan->source[k] == i)
                job->source[job->seen.n_sources++] = scene->source[i];
    job->seen.source = job->source;
    status = rl_light_set_make_kept(&job->lights, scene->light, scene->n_lights, plan->light, plan->n_lights,
                                    error);
    if (status == RL_OK)
        job->lights->unit = RL_UNIT_SINGLE;
    return status;
}

static int make_visible(struct rl_render_job *job, struct rl_error *error)
{
    size_t n = job->scene->n_objects;
    bool *drawn = calloc(n + 1, sizeof *drawn);
    if (!drawn)
        return rl_fail_memory(error, "the CPU renderer");
    for (size_t i = 0; i < n; i++)
        drawn[i] = job->plan->object[i].drawn;
    int status = rl_visible_make(&job->visible, job->scene, drawn, job->plan->settings.culling, error);
    free(drawn);
    return status;
}

static int make_environments(struct rl_render_job *job, struct rl_error *error)
{
    const struct rl_plan *plan = job->plan;
    size_t made = 0;
    int status = RL_OK;
    for (size_t i = 0; i < job->scene->n_objects && status == RL_OK; i++)
        if (plan->environment[i] == (int)made) /* others are those of an object before, at the same centre */
            status = rl_texel_map_make(&job->environment[made++], job->lights, job->scene->object[i].centre,
                                       plan->settings.env_size, error);
    return status;
}

const struct rl_render_shader *rl_render_shader_of(const struct rl_render_job *job, size_t object)
{
    const struct rl_plan_material *m = rl_plan_of_object(job->plan, job->scene, object);
    return &job->shader[m - job->plan->material];
}

static int make_interpolated(struct rl_render_job *job, int threads, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < job->scene->n_objects && status == RL_OK; i++) {
        if (!job->plan->object[i].drawn)
            continue;
        const struct rl_render_shader *s = rl_render_shader_of(job, i);
        const struct rl_interpolated_shading shading = {
            .effect = s->plan->effect,
            .n_effects = s->plan->n_effects,
            .params = (double(*)[RL_EFFECT_PARAMS][4])s->effect_params,
            .lights = &job->seen,
            .eye = job->scene->camera.position,
            .both_sides = !job->plan->settings.culling,
            .shadows = job->shadows,
            .view = job->shadow_view,
            .object = i,
        };
        status = rl_interpolated_make(&job->interpolated[i], &job->scene->object[i].mesh,
                                      s->plan->interpolation, &shading, threads, error);
    }
    return status;
}

static int make_shadows(struct rl_render_job *job, struct rl_error *error)
{
    int status = rl_shadow_rays_make(&job->rays, job->scene, error);
    if (status == RL_OK)
        status = rl_occluders_make(&job->occluders, job->scene, job->rays, error);
    if (status == RL_OK)
        status = rl_shadows_make(&job->shadows, job->scene, job->rays, job->occluders, &job->seen,
                                 job->plan->light, job->plan->settings.tolerance, error);
    return status;
}

int rl_render_job_make(struct rl_render_job *job, const struct rl_scene *scene, const struct rl_plan *plan,
                       struct rl_image *image, struct rl_image *errors, int threads, struct rl_error *error)
{
    *job = (struct rl_render_job){.scene = scene, .plan = plan, .image = image, .errors = errors};
    if (plan->shadows) {
        job->view = calloc((size_t)threads, sizeof *job->view);
        job->shadow_view = calloc((size_t)threads, sizeof *job->shadow_view);
    }
    job->n_views = job->view ? threads : 0;
    job->reached = calloc((size_t)image->width * (size_t)image->height, sizeof *job->reached);
    job->shader = calloc(plan->n_materials + 1, sizeof *job->shader);
    job->environment = calloc(plan->n_environments + 1, sizeof(struct rl_texel_map *));
    job->interpolated = calloc(scene->n_objects + 1, sizeof *job->interpolated);
    if (!job->reached || !job->shader || !job->environment || !job->interpolated ||
        (plan->shadows && (!job->view || !job->shadow_view))) {
        rl_render_job_clear(job);
        return rl_fail_memory(error, "the CPU renderer");
    }
    for (size_t i = 0; i < plan->n_materials; i++)
        make_shader(&job->shader[i], scene, &plan->material[i]);
    int status = make_lights(job, error);
    if (status == RL_OK)
        status = make_visible(job, error);
    if (status == RL_OK)
        status = make_environments(job, error);
    if (status == RL_OK && plan->shadows)
        status = make_shadows(job, error);
    if (status == RL_OK)
        status = make_interpolated(job, threads, error);
    if (status != RL_OK)
        rl_render_job_clear(job);
    return status;
}
