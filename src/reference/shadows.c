/* Visibility of lights for effects (see shadows.h). */
#include "reference/shadows.h"

#include <math.h>
#include <stdlib.h>

#include "reference/integrator.h"

/* One polygon of a shaped light: its light in the scene, and itself alone, of radiance 1. */
struct area {
    size_t light;
    struct rl_light_set *set;
};

struct rl_shadows {
    const struct rl_shadow_rays *rays;
    const struct rl_occluders *occluders;
    const struct rl_lights *lights;
    const struct rl_effect *diffuse_area;
    struct rl_ellipsoid ellipsoid; /* asked for by the integrator, and not used */
    double tolerance;
    size_t n_areas;
    struct area *area;
};

static int make_areas(struct rl_shadows *s, const struct rl_scene *scene, const size_t *index,
                      struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < s->lights->n_points; i++) {
        size_t light = index ? index[i] : i;
        for (size_t j = 0; j < scene->light[light].n_polygons && status == RL_OK; j++) {
            struct area *area = &s->area[s->n_areas];
            const struct rl_area_light *polygon = &s->lights->area[s->n_areas];
            area->light = light;
            status = rl_light_set_from_polygons(&area->set, &polygon->vertex,
                                                &(const size_t){(size_t)polygon->n}, 1, error);
            if (status == RL_OK)
                area->set->unit = s->lights->unit;
            s->n_areas += status == RL_OK;
        }
    }
    return status;
}

int rl_shadows_make(struct rl_shadows **out, const struct rl_scene *scene, const struct rl_shadow_rays *rays,
                    const struct rl_occluders *occluders, const struct rl_lights *lights, const size_t *index,
                    double tolerance, struct rl_error *error)
{
    struct rl_shadows *s = calloc(1, sizeof *s);
    *out = NULL;
    if (!s)
        return rl_fail_memory(error, "the shadows");
    *s = (struct rl_shadows){.rays = rays,
                             .occluders = occluders,
                             .lights = lights,
                             .diffuse_area = rl_effect_find("diffuse-area"),
                             .ellipsoid = rl_ellipsoid_make(1.0),
                             .tolerance = tolerance,
                             .area = calloc(lights->n_areas + 1, sizeof *s->area)};
    int status = s->area ? make_areas(s, scene, index, error) : rl_fail_memory(error, "the lights' polygons");
    if (status != RL_OK)
        rl_shadows_free(s);
    else
        *out = s;
    return status;
}

void rl_shadows_free(struct rl_shadows *shadows)
{
    if (!shadows)
        return;
    for (size_t i = 0; i < shadows->n_areas; i++)
        rl_light_set_free(shadows->area[i].set);
    free(shadows->area);
    free(shadows);
}

static bool hidden(void *user, const struct rl_surface *s, rl_vec3 L, double distance)
{
    const struct rl_shadows_view *view = user;
    return rl_shadow_rays_hidden(view->shadows->rays, view->own, s->P, L, distance);
}

static bool same(rl_vec3 a, rl_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Whether anything may hide the light from this place; if so its silhouette is in view->occluders. */
static enum rl_occluders_seen see(struct rl_shadows_view *view, const struct rl_surface *at, size_t light)
{
    if (view->seen_light != light || !same(view->seen_from.P, at->P) || !same(view->seen_from.N, at->N)) {
        view->seen = rl_occluders_see_light(&view->occluders, view->shadows->occluders, at, view->own, light);
        view->seen_light = light;
        view->seen_from = *at;
    }
    return view->seen;
}

static double share(void *user, const struct rl_surface *s, size_t index, double *error)
{
    /* As for the highlight, past a number of lines the error is left as it is. */
    enum { LINES_MOST = 2000 };
    struct rl_shadows_view *view = user;
    const struct rl_shadows *shadows = view->shadows;
    const struct rl_area_light *light = &shadows->lights->area[index];
    double k_d[1][4] = {{1.0, 1.0, 1.0, 0.0}}, open[3];
    const struct rl_surface at = {s->P, s->N, s->N};
    *error = 0.0;
    shadows->diffuse_area->area(&at, light->vertex, light->n, k_d, open);
    if (!(open[0] > 0.0))
        return 1.0;
    enum rl_occluders_seen seen = see(view, &at, shadows->area[index].light);
    if (seen == RL_OCCLUDERS_NONE)
        return 1.0;
    /* No picture comes of values that are not finite. */
    if (seen == RL_OCCLUDERS_NO_MEMORY)
        return NAN;
    const struct rl_integrate_options options = {.attenuation = true,
                                                 .irradiance = true,
                                                 .tolerance = shadows->tolerance,
                                                 .max_evaluations = LINES_MOST,
                                                 .occlusion = &view->occluders.occlusion};
    struct rl_estimate estimate;
    view->occluders.occlusion.hidden = 0;
    rl_integrate_lines(&estimate, &at, &shadows->ellipsoid, shadows->area[index].set, &options);
    *error = RL_PI * estimate.error[0] / open[0];
    /* Where nothing was met the sum over edges is the better answer. */
    if (view->occluders.occlusion.hidden == 0)
        return 1.0;
    return fmax(0.0, fmin(1.0, RL_PI * estimate.value[0] / open[0]));
}

const struct rl_visibility *rl_shadows_see(struct rl_shadows_view *view, const struct rl_shadows *shadows,
                                           size_t own)
{
    /* What was seen from another object does not hold for this one. */
    if (view->shadows != shadows || view->own != own)
        view->seen_light = RL_OCCLUDERS_LIGHTS;
    view->visibility = (struct rl_visibility){hidden, share, view};
    view->shadows = shadows;
    view->own = own;
    return &view->visibility;
}

void rl_shadows_view_clear(struct rl_shadows_view *view)
{
    rl_occluders_view_clear(&view->occluders);
    *view = (struct rl_shadows_view){0};
}
