/* What the CPU renderer works out before it draws: materials, lights, what Embree knows, environment maps, interpolated shading. Read-only
 * afterwards, but for the image and what each pixel has reached; renderer.c draws with it. */
#ifndef RL_REFERENCE_RENDER_JOB_H
#define RL_REFERENCE_RENDER_JOB_H

#include "reference/accuracy.h"
#include "reference/interpolated.h"
#include "reference/light_set.h"
#include "reference/occluders.h"
#include "reference/shadows.h"
#include "reference/texel_map.h"
#include "reference/visible.h"
#include "scene/plan.h"

/* A material as the loop over pixels wants it: everything that does not depend on the pixel is worked out. */
struct rl_render_shader {
    const struct rl_plan_material *plan;
    const struct rl_material *material;
    struct rl_ellipsoid ellipsoid;
    double effect_params[RL_PLAN_EFFECTS_MAX][RL_EFFECT_PARAMS][4];
    double method_params[RL_EFFECT_PARAMS][4];
    bool integrates; /* the highlight is the integral itself */
};

struct rl_render_job {
    const struct rl_scene *scene;
    const struct rl_plan *plan;
    struct rl_image *image, *errors; /* errors: NULL if not wanted */
    struct rl_accuracy *reached;     /* per pixel */
    struct rl_visible *visible;
    struct rl_light_set *lights;
    struct rl_shadow_rays *rays;         /* NULL: no shadows */
    struct rl_occluders *occluders;      /* with rays */
    struct rl_occluders_view *view;      /* with rays: of the highlight, one a thread */
    struct rl_shadows *shadows;          /* with rays: of the effects */
    struct rl_shadows_view *shadow_view; /* with rays: one a thread */
    int n_views;
    struct rl_source *source;             /* those that are not dropped, in the scene's order */
    struct rl_lights seen;                /* by effects, and by methods that take points */
    struct rl_render_shader *shader;      /* per plan material */
    struct rl_texel_map **environment;    /* plan->n_environments */
    struct rl_interpolated *interpolated; /* per object */
};

/* `scene`, `plan` and the images must outlive it. errors: NULL if not wanted. threads: that will draw, at least 1. */
int rl_render_job_make(struct rl_render_job *job, const struct rl_scene *scene, const struct rl_plan *plan,
                       struct rl_image *image, struct rl_image *errors, int threads, struct rl_error *error);
void rl_render_job_clear(struct rl_render_job *job);

/* Of the material that an object in view wears. */
const struct rl_render_shader *rl_render_shader_of(const struct rl_render_job *job, size_t object);

#endif
