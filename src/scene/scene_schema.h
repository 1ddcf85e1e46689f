/* A scene file as libcyaml fills it, value by value as written: what is optional and absent is NULL.
 * scene_build.c turns it into a struct rl_scene. The tables in scene_schema.c are the format's definition. Numbers with units are left to
 * scene_strength.c, which reads them from the tree. */
#ifndef RL_SCENE_SCENE_SCHEMA_H
#define RL_SCENE_SCENE_SCHEMA_H

#include <stdint.h>

#include "base/error.h"
#include "effects/effect.h"
#include "scene/shapes.h"
#include "scene/yaml_tree.h"

struct rl_raw_film {
    int width, height;
};

struct rl_raw_camera {
    double position[3], target[3];
    double *up;
    double field_of_view; /* degrees, vertical */
    double *near, *far;
};

/* The parameters of an effect, in its descriptor's order: a number, a colour's three, or which of its choices. */
struct rl_raw_effect {
    void *value[RL_EFFECT_KEYS_MAX];
};

struct rl_raw_material {
    char *name;
    double *rr;
    double *specular;
    char *highlight;
    enum rl_interpolation *interpolation;
    /* By row of rl_effects; the parameter itself where the effect has one without a key, else a struct rl_raw_effect. */
    void *effect[RL_MATERIAL_EFFECTS_MAX];
};

struct rl_raw_placement { /* in this order */
    double *scale;
    double *stretch;
    double *rotate; /* degrees about x, then y, then z */
    double *translate;
};

struct rl_raw_object {
    char *name;
    enum rl_shape shape;
    char *file;
    char *material;
    int *tessellation;
    double *minor;
    struct rl_raw_placement placement;
};

struct rl_raw_light {
    char *name;
    double (*polygon)[3];
    unsigned n_polygon;
    char *mesh;
    struct rl_raw_placement placement;
    double *position, *direction;              /* of a light without shape */
    double *radiance, *intensity, *irradiance; /* its strength, by kind of light */
    double *colour;                            /* of a photometric strength */
};

enum rl_raw_switch { RL_RAW_OFF, RL_RAW_ON };

struct rl_raw_render {
    int *samples;
    char *normal_bits;
    int *normal_size;
    int *env_size;
    char *env_format;
    char *margin;
    enum rl_raw_switch *attenuation;
    enum rl_raw_switch *shadows;
    enum rl_raw_switch *culling;
    int *depth_bits;
    enum rl_raw_switch *reversed_depth;
    char *frame;
    uint64_t *seed;
    double *tolerance;
};

struct rl_raw_scene {
    struct rl_raw_film *film;
    struct rl_raw_camera camera;
    struct rl_raw_material *materials;
    struct rl_raw_object *objects;
    struct rl_raw_light *lights;
    unsigned n_materials, n_objects, n_lights;
    struct rl_raw_render *render;
};

/* Parses, checks against the schema and loads. `tree` stays for messages about meaning; clear both, also
 * after an error. */
int rl_raw_scene_load(struct rl_raw_scene **raw, struct rl_yaml_tree *tree, const char *path,
                      const char *text, size_t size, struct rl_error *error);
void rl_raw_scene_free(struct rl_raw_scene *raw);

#endif
