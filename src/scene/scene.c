/* Loads a scene file: film, materials and the render block here, the rest in the files beside (see
 * scene_build.h). */
#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "base/hash.h"
#include "methods/method.h"
#include "model/ellipsoid.h"
#include "scene/effect_schema.h"
#include "scene/scene_build.h"

int rl_build_range(const struct rl_scene_builder *b, const char *key, double value, double low, double high)
{
    if (value >= low && value <= high)
        return RL_OK;
    return rl_yaml_fail_value(b->tree, b->error, key, "%g to %g", low, high);
}

int rl_build_triple(const struct rl_scene_builder *b, const char *key, const double value[3], double low,
                    double high)
{
    for (int i = 0; i < 3; i++) {
        char path[RL_YAML_KEY_MAX];
        snprintf(path, sizeof path, "%.150s[%d]", key, i);
        if (rl_build_range(b, path, value[i], low, high) != RL_OK)
            return RL_ERR_INPUT;
    }
    return RL_OK;
}

static int build_film(const struct rl_scene_builder *b)
{
    static const struct rl_raw_film default_film = {640, 480};
    const struct rl_raw_film *film = b->raw->film ? b->raw->film : &default_film;
    b->scene->width = film->width;
    b->scene->height = film->height;
    int status = rl_build_range(b, "film.width", film->width, 1, RL_FILM_MAX);
    return status == RL_OK ? rl_build_range(b, "film.height", film->height, 1, RL_FILM_MAX) : status;
}

/* ---- Materials ---- */

static int build_specular(const struct rl_scene_builder *b, double colour[3], const double *given,
                          const char *material)
{
    for (int i = 0; i < 3; i++)
        colour[i] = given ? given[i] : 1.0;
    char path[RL_YAML_KEY_MAX];
    rl_yaml_key(path, material, "specular");
    return rl_build_triple(b, path, colour, 0.0, RL_COLOUR_MAX);
}

/* `highlight` and `rr` belong together: without rr there is no highlight unless one is named, and then rr
 * is missed. */
static int build_highlight(const struct rl_scene_builder *b, struct rl_material *material,
                           const struct rl_raw_material *raw, const char *key)
{
    char path[RL_YAML_KEY_MAX];
    const char *name = raw->highlight ? raw->highlight : raw->rr ? "random" : "none";
    const struct rl_method *method = rl_method_find(name);
    rl_yaml_key(path, key, "highlight");
    if (!method && strcmp(name, "none") != 0) {
        char names[256];
        rl_method_names(names, sizeof names);
        return rl_yaml_fail_value(b->tree, b->error, path, "%s, or none", names);
    }
    material->method = method ? method->name : NULL;
    material->rr = raw->rr ? *raw->rr : 1.0;
    rl_yaml_key(path, key, "rr");
    if (method && !raw->rr)
        return rl_yaml_fail_value(b->tree, b->error, path, "the roughness R_r of the highlight");
    return rl_build_range(b, path, material->rr, RL_RR_MIN, RL_RR_MAX);
}

static int build_material(const struct rl_scene_builder *b, size_t i)
{
    const struct rl_raw_material *raw = &b->raw->materials[i];
    struct rl_material *material = &b->scene->material[i];
    char key[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "materials[%zu]", i);
    material->name = strdup(raw->name);
    if (!material->name)
        return rl_fail_memory(b->error, key);
    material->interpolation = raw->interpolation ? *raw->interpolation : RL_INTERPOLATION_PHONG;
    int status = build_highlight(b, material, raw, key);
    if (status == RL_OK)
        status = build_specular(b, material->specular, raw->specular, key);
    if (status == RL_OK)
        status = rl_build_effects(b, i);
    return status;
}

static int build_materials(const struct rl_scene_builder *b)
{
    b->scene->material = calloc(b->raw->n_materials, sizeof *b->scene->material);
    if (!b->scene->material)
        return rl_fail_memory(b->error, "the materials");
    for (size_t i = 0; i < b->raw->n_materials; i++) {
        b->scene->n_materials = i + 1;
        int status = build_material(b, i);
        if (status != RL_OK)
            return status;
    }
    return RL_OK;
}

/* ---- Names ---- */

static int check_name(const struct rl_scene_builder *b, const char *list, size_t i, const char *name,
                      size_t earlier, const char *other)
{
    if (!name || !other || strcmp(name, other) != 0)
        return RL_OK;
    char key[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "%s[%zu].name", list, i);
    return rl_yaml_fail_value(b->tree, b->error, key, "a name of its own, for %s[%zu] has it", list, earlier);
}

static int check_names(const struct rl_scene_builder *b)
{
    const struct rl_raw_scene *raw = b->raw;
    int status = RL_OK;
    for (size_t i = 0; i < raw->n_materials && status == RL_OK; i++)
        for (size_t j = 0; j < i && status == RL_OK; j++)
            status = check_name(b, "materials", i, raw->materials[i].name, j, raw->materials[j].name);
    for (size_t i = 0; i < raw->n_objects && status == RL_OK; i++)
        for (size_t j = 0; j < i && status == RL_OK; j++)
            status = check_name(b, "objects", i, raw->objects[i].name, j, raw->objects[j].name);
    for (size_t i = 0; i < raw->n_lights && status == RL_OK; i++)
        for (size_t j = 0; j < i && status == RL_OK; j++)
            status = check_name(b, "lights", i, raw->lights[i].name, j, raw->lights[j].name);
    return status;
}

/* ---- The render block ---- */

static int parse_texts(const struct rl_scene_builder *b, const struct rl_raw_render *raw, const char **key)
{
    struct rl_settings *s = &b->scene->settings;
    int status = RL_OK;
    *key = "normal-bits";
    if (raw->normal_bits)
        status = rl_parse_normal_bits(&s->normal_bits, raw->normal_bits, NULL, b->error);
    if (status != RL_OK)
        return status;
    *key = "env-format";
    if (raw->env_format)
        status = rl_parse_texel_format(&s->env_format, raw->env_format, NULL, b->error);
    if (status != RL_OK)
        return status;
    *key = "margin";
    if (raw->margin)
        status = rl_parse_margin(s, raw->margin, NULL, b->error);
    if (status != RL_OK)
        return status;
    *key = "frame";
    if (raw->frame)
        status = rl_parse_frame(&s->frame, raw->frame, NULL, b->error);
    return status;
}

static int build_settings(const struct rl_scene_builder *b)
{
    struct rl_settings *s = &b->scene->settings;
    const struct rl_raw_render *raw = b->raw->render;
    *s = RL_SETTINGS_DEFAULT;
    if (!raw)
        return RL_OK;
    const char *name;
    int status = parse_texts(b, raw, &name);
    if (status == RL_OK) {
        s->samples = raw->samples ? *raw->samples : s->samples;
        s->normal_size = raw->normal_size ? *raw->normal_size : s->normal_size;
        s->env_size = raw->env_size ? *raw->env_size : s->env_size;
        s->attenuation = raw->attenuation ? *raw->attenuation == RL_RAW_ON : s->attenuation;
        s->shadows = raw->shadows ? *raw->shadows == RL_RAW_ON : s->shadows;
        s->culling = raw->culling ? *raw->culling == RL_RAW_ON : s->culling;
        s->depth_bits = raw->depth_bits ? *raw->depth_bits : s->depth_bits;
        s->reversed_depth = raw->reversed_depth ? *raw->reversed_depth == RL_RAW_ON : s->reversed_depth;
        s->seed = raw->seed ? *raw->seed : s->seed;
        s->tolerance = raw->tolerance ? *raw->tolerance : s->tolerance;
        /* In a file 0 samples are a slip, not the wish for the method's default. */
        if (raw->samples && *raw->samples == 0)
            return rl_build_range(b, "render.samples", 0.0, 1, RL_SAMPLES_MAX);
        status = rl_settings_check_key(s, &name, b->error);
    }
    if (status == RL_OK)
        return RL_OK;
    char key[RL_YAML_KEY_MAX], message[512];
    snprintf(key, sizeof key, "render.%s", name);
    snprintf(message, sizeof message, "%.500s", b->error ? b->error->message : "");
    return rl_yaml_fail(b->tree, b->error, key, "%s", message);
}

/* ---- The whole ---- */

static int build(const struct rl_scene_builder *b)
{
    int status = build_film(b);
    if (status == RL_OK)
        status = rl_build_camera(b);
    if (status == RL_OK)
        status = check_names(b);
    if (status == RL_OK)
        status = build_settings(b);
    if (status == RL_OK)
        status = rl_build_white(b);
    if (status == RL_OK)
        status = build_materials(b);
    if (status == RL_OK)
        status = rl_build_lights(b);
    if (status == RL_OK)
        status = rl_build_objects(b);
    return status == RL_OK ? rl_build_camera_planes(b) : status;
}

int rl_scene_load(struct rl_scene *scene, const char *path, struct rl_error *error)
{
    *scene = (struct rl_scene){.hash = RL_HASH_START};
    char *text;
    size_t size;
    int status = rl_file_read(&text, &size, path, error);
    if (status != RL_OK)
        return status;
    struct rl_yaml_tree tree = {0};
    struct rl_raw_scene *raw = NULL;
    scene->path = strdup(path);
    scene->hash = rl_hash_bytes(scene->hash, text, size);
    status = rl_raw_scene_load(&raw, &tree, path, text, size, error);
    if (!scene->path)
        status = rl_fail_memory(error, path);
    free(text);
    if (status == RL_OK) {
        struct rl_scene_builder b = {.raw = raw, .tree = &tree, .scene = scene, .error = error};
        status = build(&b);
    }
    rl_raw_scene_free(raw);
    rl_yaml_clear(&tree);
    if (status != RL_OK)
        rl_scene_clear(scene);
    return status;
}

void rl_scene_clear(struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_materials; i++)
        free(scene->material[i].name);
    for (size_t i = 0; i < scene->n_objects; i++) {
        free(scene->object[i].name);
        rl_mesh_clear(&scene->object[i].mesh);
    }
    for (size_t i = 0; i < scene->n_lights; i++) {
        for (size_t j = 0; j < scene->light[i].n_polygons; j++)
            rl_polygon_clear(&scene->light[i].polygon[j]);
        free(scene->light[i].polygon);
        free(scene->light[i].name);
    }
    for (size_t i = 0; i < scene->n_sources; i++)
        free(scene->source[i].name);
    free(scene->material);
    free(scene->object);
    free(scene->light);
    free(scene->source);
    free(scene->path);
    *scene = (struct rl_scene){0};
}
