/* The objects of a scene file: built-in shapes and mesh files, placed in the world. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/scene_build.h"

/* Fine enough for outlines to look round at 640 x 480. */
static const int default_tessellation[] = {
    [RL_SHAPE_SPHERE] = 32, [RL_SHAPE_TORUS] = 32,  [RL_SHAPE_PLANE] = 1,
    [RL_SHAPE_DISC] = 32,   [RL_SHAPE_TEAPOT] = 16,
};
static const double default_minor = 0.4;

/* A key that the shape does not know is an error and not ignored. */
static int check_keys(const struct rl_scene_builder *b, const struct rl_raw_object *raw, const char *key)
{
    char path[RL_YAML_KEY_MAX];
    bool mesh = raw->shape == RL_SHAPE_MESH;
    if (mesh && !raw->file) {
        rl_yaml_key(path, key, "file");
        return rl_yaml_fail_value(b->tree, b->error, path, "the name of a mesh file, for shape: mesh");
    }
    const struct {
        const char *key;
        bool given, allowed;
        const char *with;
    } keys[] = {
        {"file", raw->file != NULL, mesh, "mesh"},
        {"tessellation", raw->tessellation != NULL, !mesh, "sphere, torus, plane, disc or teapot"},
        {"minor", raw->minor != NULL, raw->shape == RL_SHAPE_TORUS, "torus"},
    };
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
        if (keys[i].given && !keys[i].allowed) {
            rl_yaml_key(path, key, keys[i].key);
            return rl_yaml_fail(b->tree, b->error, path, "found it with shape: %s, expected only with %s",
                                rl_shape_name(raw->shape), keys[i].with);
        }
    return RL_OK;
}

static int build_mesh(const struct rl_scene_builder *b, struct rl_mesh *mesh, const struct rl_raw_object *raw,
                      const char *key)
{
    char path[RL_YAML_KEY_MAX];
    if (raw->shape == RL_SHAPE_MESH) {
        rl_yaml_key(path, key, "file");
        return rl_build_mesh_file(b, mesh, raw->file, path);
    }
    int tessellation = raw->tessellation ? *raw->tessellation : default_tessellation[raw->shape];
    double minor = raw->minor ? *raw->minor : default_minor;
    rl_yaml_key(path, key, "tessellation");
    int status = rl_build_range(b, path, tessellation, RL_TESSELLATION_MIN, RL_TESSELLATION_MAX);
    if (status == RL_OK && raw->minor) {
        rl_yaml_key(path, key, "minor");
        status = rl_build_range(b, path, minor, 1e-3, 0.999);
    }
    return status == RL_OK ? rl_shape_build(mesh, raw->shape, tessellation, minor, b->error) : status;
}

static int find_material(const struct rl_scene_builder *b, int *index, const char *name, const char *key)
{
    for (size_t i = 0; i < b->scene->n_materials; i++)
        if (strcmp(b->scene->material[i].name, name) == 0) {
            *index = (int)i;
            return RL_OK;
        }
    char path[RL_YAML_KEY_MAX];
    rl_yaml_key(path, key, "material");
    return rl_yaml_fail_value(b->tree, b->error, path, "the name of one of the %zu materials",
                              b->scene->n_materials);
}

static int build_object(const struct rl_scene_builder *b, size_t i)
{
    const struct rl_raw_object *raw = &b->raw->objects[i];
    struct rl_object *object = &b->scene->object[i];
    char key[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "objects[%zu]", i);
    object->name = strdup(raw->name ? raw->name : key);
    if (!object->name)
        return rl_fail_memory(b->error, key);
    struct rl_placement placement;
    int status = check_keys(b, raw, key);
    if (status == RL_OK)
        status = find_material(b, &object->material, raw->material, key);
    if (status == RL_OK)
        status = rl_build_placement(&placement, b, &raw->placement, key);
    if (status == RL_OK)
        status = build_mesh(b, &object->mesh, raw, key);
    if (status != RL_OK)
        return status;
    rl_place_mesh(&placement, &object->mesh);
    rl_vec3 low, high;
    rl_mesh_bounds(&object->mesh, &low, &high, &object->centre, &object->radius);
    return rl_build_extent(b, key, object->centre, object->radius);
}

int rl_build_objects(const struct rl_scene_builder *b)
{
    b->scene->object = calloc(b->raw->n_objects, sizeof *b->scene->object);
    if (!b->scene->object)
        return rl_fail_memory(b->error, "the objects");
    for (size_t i = 0; i < b->raw->n_objects; i++) {
        b->scene->n_objects = i + 1;
        int status = build_object(b, i);
        if (status != RL_OK)
            return status;
    }
    return RL_OK;
}
