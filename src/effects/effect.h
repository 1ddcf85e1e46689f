/* Effects: what a material can ask for beside the highlight of shaped lights. Each is src/effects/NAME.c here <-> shaders/effects/NAME.glsl
 * on the GPU, one descriptor, one row of rl_effects (table.c). Adding one touches nothing else: scene files, the planner, both renderers,
 * `probe` and the tests of parity work from the descriptor. In file names and in GLSL `-` is written `_`.
 *
 * An effect has some of four functions; but for the last each returns RGB radiance towards the eye. In C they are members of the descriptor, and the GLSL
 * module defines those of them that there are, with K = n_params:
 *
 *     constant   vec3 constant_NAME(vec4 params[K])                                  of no light, the same at every point, so that each pixel
 *                                                                                    has it as it is, however the others are
 *                                                                                    interpolated; alone in its effect
 *     reflect    vec3 reflect_NAME(Surface s, vec3 L, vec4 params[K])                of light from direction L (unit), for an irradiance of
 *                                                                                    1 on a plane perpendicular to L
 *     area       vec3 area_NAME(Surface s, int first, int n, vec4 params[K])         of a polygon of radiance 1, given by its vertices
 *                                                                                    polygon_vertex(first + i), i < n;
 *                                                                                    inside of #if N_POLYGONS > 0: else
 *                                                                                    there is no polygon_vertex
 *     factor     vec3 factor_NAME(Surface s, vec4 params[K])                         no radiance: what the highlight of shaped lights is
 *                                                                                    multiplied by; alone in its effect
 *
 * The sums over lights are rl_effects_shade in C and generated in GLSL, one loop for all effects of a material. What a scene file says of
 * an effect is its key in a material:
 *
 *     phong: {specular: [1, 1, 1], exponent: 30}           parameters by their keys,
 *     diffuse: [0.1, 0.2, 0.3]                             or one parameter without a key of its own
 */
#ifndef RL_EFFECTS_EFFECT_H
#define RL_EFFECTS_EFFECT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "model/material.h"
#include "model/vec3.h"

enum { RL_EFFECT_PARAMS = 4, RL_EFFECT_KEYS_MAX = 8, RL_EFFECT_CHOICES_MAX = 4, RL_EFFECT_MODULES_MAX = 5 };

/* A visible point: position, unit shading normal on the eye's side, unit direction to the eye. */
struct rl_surface {
    rl_vec3 P, N, V;
};

/* A shaped light shrunk to a point at its centroid, for effects that do not see its shape: a one-sided patch would have
 * radiance x area / r^2 x cosine; lights shine from both sides, so the cosine enters as |cos|. */
struct rl_point_light {
    rl_vec3 position;
    rl_vec3 normal; /* unit; zero for a light that is not flat: no cosine at the light */
    double area;
    double radiance[3];
};

/* A light without shape. */
struct rl_source {
    char *name;
    bool parallel;
    rl_vec3 at; /* its position; parallel: the unit direction towards it */
    double strength
        [3]; /* radiant intensity (E = I/r^2); parallel: irradiance on a plane perpendicular to its rays; RGB, >= 0 */
};

/* A polygon that shines from both sides. */
struct rl_area_light {
    const rl_vec3 *vertex; /* the scene's */
    int n;
    double radiance
        [3]; /* of a closed mesh's polygons half the mesh's: a ray into a convex body meets two of its faces */
};

/* What stands between a point and the lights: given by whoever knows what hides what, asked by rl_effects_shade. */
struct rl_visibility {
    /* Whether something hides what lies in direction L (unit) at this distance; INFINITY: parallel light. */
    bool (*hidden)(void *user, const struct rl_surface *s, rl_vec3 L, double distance);
    /* The share, 0 to 1, that arrives of the irradiance which the lights' area `index` would give if nothing hid it; *error: how far off it may
     * be. Exactly 1 where nothing does; NAN: it could not be found out. */
    double (*share)(void *user, const struct rl_surface *s, size_t index, double *error);
    void *user;
};

/* The lights of a scene as effects see them; see rl_scene_lights_make. */
struct rl_lights {
    const struct rl_visibility *visibility; /* NULL: nothing hides them */
    size_t n_points, n_sources, n_areas;
    struct rl_area_light *area;   /* every polygon of every shaped light */
    struct rl_point_light *point; /* every shaped light */
    const struct rl_source *source;
    double
        unit; /* of rounding of the points that see them (model/plane.h): a polygon in whose plane they lie gives nothing */
};

/* Light from one direction: unit L, the irradiance on a plane perpendicular to it, and how far it has come. */
struct rl_incident {
    rl_vec3 L;
    double irradiance[3];
    double distance; /* INFINITY: parallel */
};

/* What arrives at P. False: the light is at P itself and has no direction, and gives nothing; nor does a flat one in whose plane P is by its
 * coordinates' rounding (`unit`, model/plane.h). */
bool rl_incident_from_source(struct rl_incident *incident, const struct rl_source *source, rl_vec3 P);
bool rl_incident_from_centroid(struct rl_incident *incident, const struct rl_point_light *light, rl_vec3 P,
                               double unit);

/* ---- Parameters ---- */

enum rl_effect_kind { RL_EFFECT_NUMBER, RL_EFFECT_COLOUR, RL_EFFECT_CHOICE };

/* A choice is made when shaders are linked, never when they run: each of its answers is a module of its own, and the modules of one choice
 * define the same function. */
struct rl_effect_choice {
    const char *name, *module; /* NULL ends the list; module: a path as in plans, "common/beckmann" */
};

struct rl_effect_param {
    const char *key;  /* in the effect's block; NULL: the effect's own key holds the value */
    const char *help; /* NULL ends the list */
    const struct rl_effect_choice
        *choice; /* of a number, where it has them: the first if it is 0, else the second */
    double low, high;
    double absent[3]; /* the value where the key is left out; NAN: not given */
    enum rl_effect_kind kind;
    bool required;
    bool coefficient; /* the effect does something only where one of its coefficients is not 0 */
    bool radiance;    /* it adds to what is seen by itself, so a photometric scene has it in cd/m^2 */
};

/* ---- Descriptors ---- */

/* What of the lights enters. */
enum rl_effect_sees {
    RL_SEES_SOURCES = 1,   /* point and parallel lights; with `reflect` */
    RL_SEES_CENTROIDS = 2, /* shaped lights shrunk to points; with `reflect` */
    RL_SEES_POLYGONS = 4   /* shaped lights as they are; with `area` */
};

/* Which of the functions an effect has. */
enum rl_effect_gives {
    RL_GIVES_CONSTANT = 1,  /* `constant` */
    RL_GIVES_REFLECTED = 2, /* `reflect`, `area`: what is interpolated where a material asks for that */
    RL_GIVES_FACTOR = 4     /* `factor` */
};

/* What an effect is a model of. Two effects of one material that are models of the same thing are an error. */
enum rl_effect_role {
    RL_ROLE_DIFFUSE = 1,  /* diffuse reflection */
    RL_ROLE_SPECULAR = 2, /* the highlight of point and parallel lights */
    RL_ROLE_HIGHLIGHT = 4 /* the highlight of shaped lights, which is the methods' */
};

struct rl_effect {
    const char *name;
    const char *summary; /* one line for --help and plan */
    unsigned sees;       /* enum rl_effect_sees */
    unsigned roles;      /* enum rl_effect_role */
    bool
        below; /* light from below the horizon counts as well; else `reflect` is 0 where N.L <= 0, and `area` of what is there */
    /* `reflect` can be below 0, as printed formulas have it. Where a light or a coefficient is 0 its term is -0, and its GLSL needs
     * "common/positive_zero" among the modules: else dropping what gives nothing would change the sign of black. */
    bool negative;
    const struct rl_effect_param *param;
    const char *modules[RL_EFFECT_MODULES_MAX]; /* what the GLSL module needs beside those of its choices */
    /* Combinations of values that make no sense: NULL, or what was expected, and at which key. NULL where there are none. */
    const char *(*check)(const double *value, const char **key);
    /* vec4 of its own that the functions get, made from the material's values. */
    int n_params;
    void (*pack)(const double *value, double params[][4]);
    void (*constant)(double params[][4], double rgb[3]);
    void (*reflect)(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3]);
    void (*area)(const struct rl_surface *s, const rl_vec3 *vertex, int n, double params[][4], double rgb[3]);
    void (*factor)(const struct rl_surface *s, double params[][4], double rgb[3]);
    /* |GLSL - C| <= absolute + relative |C| for a light of irradiance (area: radiance) 1. */
    double absolute, relative;
};

extern const struct rl_effect *const rl_effects[];
extern const size_t rl_n_effects;

/* NULL if there is none of that name. */
const struct rl_effect *rl_effect_find(const char *name);

enum rl_effect_gives rl_effect_gives(const struct rl_effect *effect);

/* Its row in rl_effects. */
size_t rl_effect_row(const struct rl_effect *effect);

/* The name as file names and GLSL have it. */
void rl_effect_identifier(char identifier[32], const struct rl_effect *effect);

/* How many values the parameters have, and where those of the i-th begin. */
size_t rl_effect_values(const struct rl_effect *effect);
size_t rl_effect_value_of(const struct rl_effect *effect, size_t param);

/* The module that the material's choice links, for the i-th parameter. */
const char *rl_effect_module(const struct rl_effect *effect, const double *value, size_t param);

/* ---- Effects of a material ---- */

/* Makes the material ask for the effect, with every parameter as if left out, and returns the values to change. */
double *rl_effect_give(struct rl_material *material, const struct rl_effect *effect);
/* The same for an effect (by name, which must be one) whose only parameter is a colour. */
void rl_effect_give_colour(struct rl_material *material, const char *name, double r, double g, double b);
/* The values, or NULL: the material does not name the effect. */
const double *rl_effect_given(const struct rl_material *material, const struct rl_effect *effect);
/* Whether the material asks for the effect and one of its coefficients is not 0. */
bool rl_effect_wanted(const struct rl_material *material, const struct rl_effect *effect);

/* The sum of effects over all lights, in the order of their functions, lights and rows. params[i] is what effect i packed. */
void rl_effects_shade(const struct rl_effect *const *effects, size_t n, double params[][RL_EFFECT_PARAMS][4],
                      const struct rl_surface *s, const struct rl_lights *lights, double rgb[3]);
/* The same, and how far off the sum may be by what is known of the lights' visibility. */
void rl_effects_shade_within(const struct rl_effect *const *effects, size_t n,
                             double params[][RL_EFFECT_PARAMS][4], const struct rl_surface *s,
                             const struct rl_lights *lights, double rgb[3], double error[3]);
/* The product of the effects' factors, 1 without any. */
void rl_effects_factor(const struct rl_effect *const *effects, size_t n, double params[][RL_EFFECT_PARAMS][4],
                       const struct rl_surface *s, double rgb[3]);

#endif
