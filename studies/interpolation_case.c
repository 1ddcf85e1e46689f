/* A case of the study `interpolation`: its scene, and radiance on the exact surface and on the mesh (see interpolation.h). */
#include <string.h>

#include "studies/interpolation.h"

void rl_interpolation_case_clear(struct rl_interpolation_case *c)
{
    rl_interpolated_clear(&c->interpolated);
    rl_scene_lights_clear(&c->lights);
    rl_plan_clear(&c->plan);
    rl_interpolation_scene_free(&c->scene);
}

static int make(struct rl_interpolation_case *c, const char *parameters, struct rl_error *error)
{
    char light[RL_NAME_MAX];
    struct rl_settings settings;
    rl_parameter(parameters, "light", light, sizeof light);
    int status = rl_bench_settings(&settings, parameters, error);
    if (status == RL_OK)
        status = rl_interpolation_scene_make(&c->scene, c->object, c->tessellation, light,
                                             rl_parameter_number(parameters, "exponent"), error);
    settings.drop = false;
    if (status == RL_OK)
        status = rl_plan_make(&c->plan, &c->scene, &settings, error);
    return status == RL_OK ? rl_scene_lights_make(&c->lights, &c->scene, error) : status;
}

int rl_interpolation_case_make(struct rl_interpolation_case *c, const char *parameters, int tessellation,
                               int threads, struct rl_error *error)
{
    *c = (struct rl_interpolation_case){.tessellation = tessellation};
    rl_parameter(parameters, "object", c->object, sizeof c->object);
    int status = make(c, parameters, error);
    if (status == RL_OK) {
        const struct rl_plan_material *m = &c->plan.material[0];
        for (size_t i = 0; i < m->n_effects; i++)
            m->effect[i]->pack(rl_effect_given(&c->scene.material[0], m->effect[i]), c->params[i]);
        const struct rl_interpolated_shading shading = {.effect = m->effect,
                                                        .n_effects = m->n_effects,
                                                        .params = c->params,
                                                        .lights = &c->lights,
                                                        .eye = c->scene.camera.position};
        status = rl_interpolated_make(&c->interpolated, &c->scene.object[0].mesh, m->interpolation, &shading,
                                      threads, error);
    }
    if (status != RL_OK)
        rl_interpolation_case_clear(c);
    return status;
}

/* Light and material are grey: one channel says all. */
double rl_interpolation_radiance(struct rl_interpolation_case *c, rl_vec3 P, rl_vec3 N)
{
    const struct rl_plan_material *m = &c->plan.material[0];
    const struct rl_surface surface = {P, N, v3_normalize(v3_sub(c->scene.camera.position, P))};
    double rgb[3];
    rl_effects_shade(m->effect, m->n_effects, c->params, &surface, &c->lights, rgb);
    return rgb[0];
}

static rl_vec3 mean_of(float (*value)[3], const uint32_t corner[3], const double weight[3])
{
    rl_vec3 sum = v3(0.0, 0.0, 0.0);
    for (int k = 0; k < 3; k++)
        sum = v3_madd(sum, weight[k], v3(value[corner[k]][0], value[corner[k]][1], value[corner[k]][2]));
    return sum;
}

double rl_interpolation_mesh_radiance(struct rl_interpolation_case *c, const struct rl_mesh_point *at)
{
    const struct rl_mesh *mesh = &c->scene.object[0].mesh;
    const uint32_t *corner = mesh->triangle[at->triangle];
    double rgb[3];
    if (c->interpolated.interpolation == RL_INTERPOLATION_PHONG)
        return rl_interpolation_radiance(c, mean_of(mesh->position, corner, at->weight),
                                         v3_normalize(mean_of(mesh->normal, corner, at->weight)));
    rl_interpolated_at(rgb, &c->interpolated, at->triangle, at->weight, false);
    return rgb[0];
}
