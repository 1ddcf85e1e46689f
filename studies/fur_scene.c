/* What the study `fur` shades (see fur.h). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene/shapes.h"
#include "studies/fur.h"

const char *const rl_fur_models[] = {"kajiya-printed", "kajiya",  "goldman-printed",
                                     "goldman",        "lengyel", NULL};

/* From so far away the direction to the eye is one for all of the ball, to a tenth of a degree. */
static const double eye_distance = 1000.0, fit = 1.04;

/* Fur that is nearly as bright as Lambert's and Phong's surface under the same light. */
static const double fur_diffuse[3] = {RL_FUR_DIFFUSE, 0.7 * RL_FUR_DIFFUSE, 0.4 * RL_FUR_DIFFUSE};
static const double fur_specular[3] = {RL_FUR_SPECULAR, RL_FUR_SPECULAR, RL_FUR_SPECULAR};
static const double skin_diffuse[3] = {0.9, 0.63, 0.36};
static const double skin_specular[3] = {0.1, 0.1, 0.1};
static const double skin_exponent = 4.0;

rl_vec3 rl_fur_light(double beta_degrees)
{
    double beta = beta_degrees * RL_PI / 180.0;
    return v3(0.0, sin(beta), cos(beta));
}

/* ---- Materials ---- */

/* Gives an effect's parameter a value, a colour's from `rgb`. */
static void set(struct rl_material *m, const struct rl_effect *e, const char *key, const double *value)
{
    double *values = m->effect[rl_effect_row(e)].value;
    for (size_t i = 0; e->param[i].help; i++)
        if (strcmp(e->param[i].key ? e->param[i].key : "", key) == 0)
            memcpy(values + rl_effect_value_of(e, i), value,
                   (e->param[i].kind == RL_EFFECT_COLOUR ? 3 : 1) * sizeof *value);
}

static void wear_fur(struct rl_material *m, const struct rl_effect *e, double exponent, double monochrome)
{
    static const double c = RL_FUR_C;
    rl_effect_give(m, e);
    set(m, e, "diffuse", fur_diffuse);
    set(m, e, "specular", fur_specular);
    set(m, e, "exponent", &exponent);
    set(m, e, "monochrome", &monochrome);
    if (strncmp(e->name, "goldman", strlen("goldman")) == 0)
        set(m, e, "c", &c);
}

static int wear(struct rl_material *m, const char *parameters, struct rl_error *error)
{
    char effect[RL_NAME_MAX];
    const struct rl_material bare = {.name = m->name, .interpolation = RL_INTERPOLATION_PHONG, .rr = m->rr};
    rl_parameter(parameters, "effect", effect, sizeof effect);
    *m = bare;
    bool phong = strcmp(effect, "phong") == 0;
    if (strcmp(effect, "none") == 0) {
        rl_effect_give_colour(m, "ambient", 0.5, 0.5, 0.5);
    } else if (phong || strcmp(effect, "lambert") == 0) {
        rl_effect_give_colour(m, "diffuse", skin_diffuse[0], skin_diffuse[1], skin_diffuse[2]);
        const struct rl_effect *e = rl_effect_find("phong");
        if (phong) {
            rl_effect_give(m, e);
            set(m, e, "specular", skin_specular);
            set(m, e, "exponent", &skin_exponent);
        }
    } else {
        const struct rl_effect *e = rl_effect_find(effect);
        if (!e)
            return rl_fail(error, RL_ERR_INPUT, "effect=%s: expected a model of fur, lambert, phong or none",
                           effect);
        wear_fur(m, e, rl_parameter_number(parameters, "exponent"),
                 rl_parameters_match(parameters, "monochrome=on") ? 1.0 : 0.0);
    }
    return RL_OK;
}

/* ---- Scenes ---- */

static void set_camera(struct rl_camera *c)
{
    c->position = v3(0.0, 0.0, eye_distance);
    c->forward = v3(0.0, 0.0, -1.0);
    c->right = v3(1.0, 0.0, 0.0);
    c->up = v3(0.0, 1.0, 0.0);
    c->fov_y = 2.0 * atan(fit * tan(asin(1.0 / eye_distance)));
    c->near_plane = eye_distance - 1.1;
    c->far_plane = eye_distance + 1.1;
}

static int make_ball(struct rl_fur_scene *s, const char *parameters, struct rl_error *error)
{
    struct rl_scene *scene = &s->scene;
    s->own = true;
    scene->settings = RL_SETTINGS_DEFAULT;
    scene->material = calloc(1, sizeof *scene->material);
    scene->object = calloc(1, sizeof *scene->object);
    scene->source = calloc(1, sizeof *scene->source);
    if (!scene->material || !scene->object || !scene->source)
        return rl_fail_memory(error, "a scene");
    scene->n_materials = scene->n_objects = scene->n_sources = 1;
    struct rl_object *o = &scene->object[0];
    int status = rl_shape_build(&o->mesh, RL_SHAPE_SPHERE,
                                (int)rl_parameter_number(parameters, "tessellation"), 0.0, error);
    if (status != RL_OK)
        return status;
    rl_vec3 low, high;
    rl_mesh_bounds(&o->mesh, &low, &high, &o->centre, &o->radius);
    set_camera(&scene->camera);
    scene->source[0] =
        (struct rl_source){.parallel = true,
                           .at = rl_fur_light(rl_parameter_number(parameters, "beta")),
                           .strength = {RL_FUR_IRRADIANCE, RL_FUR_IRRADIANCE, RL_FUR_IRRADIANCE}};
    return RL_OK;
}

int rl_fur_scene_make(struct rl_fur_scene *s, const struct rl_scene *from, const char *parameters,
                      struct rl_error *error)
{
    int status = RL_OK;
    *s = (struct rl_fur_scene){0};
    if (from) {
        s->scene = *from;
        s->scene.material = malloc(from->n_materials * sizeof *from->material);
        if (!s->scene.material)
            return rl_fail_memory(error, "materials");
        memcpy(s->scene.material, from->material, from->n_materials * sizeof *from->material);
    } else {
        status = make_ball(s, parameters, error);
    }
    for (size_t i = 0; i < s->scene.n_materials && status == RL_OK; i++)
        status = wear(&s->scene.material[i], parameters, error);
    return status;
}

void rl_fur_scene_clear(struct rl_fur_scene *s)
{
    free(s->scene.material);
    if (s->own) {
        for (size_t i = 0; i < s->scene.n_objects; i++)
            rl_mesh_clear(&s->scene.object[i].mesh);
        free(s->scene.object);
        free(s->scene.source);
    }
    *s = (struct rl_fur_scene){0};
}

int rl_fur_picture(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *from,
                   const char *parameters, const char *more, struct rl_error *error)
{
    char all[RL_PARAMETERS_MAX + 64];
    struct rl_fur_scene s;
    snprintf(all, sizeof all, "%s %s", more, parameters); /* the first value of a key counts */
    int status = rl_fur_scene_make(&s, from, all, error);
    if (status == RL_OK)
        status = rl_bench_picture(image, bench, &s.scene, all, 1, error);
    rl_fur_scene_clear(&s);
    return status;
}

/* ---- Closed forms ---- */

/* Of l and e on either side of N kappa is -1, on one side 1, and halfway where N is parallel to one. */
static double direction_factor(double sin_l, double sin_e)
{
    double side = sin_l * sin_e, kappa = side > 0.0 ? 1.0 : side < 0.0 ? -1.0 : 0.0;
    return 0.5 * (1.0 + RL_FUR_C * kappa);
}

double rl_fur_closed(const char *effect, double exponent, double n, double e, double l)
{
    /* Unsigned angles of N to both lie in [0, pi]. */
    double psi = acos(cos(l - n)), theta = acos(cos(e - n));
    bool listed = strstr(effect, "-printed") != NULL;
    double cone = listed ? fabs(cos(psi - theta)) : fmax(-cos(psi + theta), 0.0);
    double facing = 2.0 * cos(l - n) + 1.0, factor = 1.0;
    if (strcmp(effect, "lengyel") == 0)
        cone = 0.5 * fabs(sin(l - n) + sin(e - n));
    else if (strncmp(effect, "goldman", strlen("goldman")) == 0)
        factor = direction_factor(sin(l - n), sin(e - n)) * (listed ? facing : fmin(fmax(facing, 0.0), 1.0));
    else if (strncmp(effect, "kajiya", strlen("kajiya")) != 0)
        return NAN;
    return RL_FUR_IRRADIANCE * factor * (RL_FUR_DIFFUSE * sin(psi) + RL_FUR_SPECULAR * pow(cone, exponent));
}
