/* Kinds of lights in a scene file, and those without shape: points and parallel light. */
#include <stdio.h>

#include "scene/scene_build.h"

static const char *const kinds[] = {[RL_LIGHT_POLYGON] = "polygon",
                                    [RL_LIGHT_MESH] = "mesh",
                                    [RL_LIGHT_POINT] = "position",
                                    [RL_LIGHT_PARALLEL] = "direction"};
enum { N_KINDS = sizeof kinds / sizeof kinds[0] };

const char *rl_light_kind_key(enum rl_light_kind kind)
{
    return kinds[kind];
}

bool rl_build_has_key(const struct rl_scene_builder *b, const char *parent, const char *key)
{
    char path[RL_YAML_KEY_MAX];
    rl_yaml_key(path, parent, key);
    return rl_yaml_find(b->tree, path) != NULL;
}

static int find_kind(const struct rl_scene_builder *b, const char *key, enum rl_light_kind *kind)
{
    int found = -1;
    for (int i = 0; i < N_KINDS; i++) {
        if (!rl_build_has_key(b, key, kinds[i]))
            continue;
        if (found >= 0)
            return rl_yaml_fail(b->tree, b->error, key, "found %s and %s, expected one of them", kinds[found],
                                kinds[i]);
        found = i;
    }
    if (found < 0)
        return rl_yaml_fail(b->tree, b->error, key,
                            "found neither polygon, mesh, position nor direction, expected one of them");
    *kind = (enum rl_light_kind)found;
    return RL_OK;
}

static int check_placement(const struct rl_scene_builder *b, const char *key, enum rl_light_kind kind)
{
    static const char *const placements[] = {"scale", "stretch", "rotate", "translate"};
    char path[RL_YAML_KEY_MAX];
    for (size_t i = 0; i < sizeof placements / sizeof placements[0]; i++)
        if (rl_build_has_key(b, key, placements[i])) {
            rl_yaml_key(path, key, placements[i]);
            return rl_yaml_fail(b->tree, b->error, path,
                                "found it with %s, expected only with polygon or mesh", kinds[kind]);
        }
    return RL_OK;
}

int rl_build_light_kind(const struct rl_scene_builder *b, size_t i, enum rl_light_kind *kind)
{
    char key[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "lights[%zu]", i);
    int status = find_kind(b, key, kind);
    if (status == RL_OK && (*kind == RL_LIGHT_POINT || *kind == RL_LIGHT_PARALLEL))
        status = check_placement(b, key, *kind);
    return status;
}

int rl_build_source(const struct rl_scene_builder *b, size_t i, struct rl_source *source)
{
    const struct rl_raw_light *raw = &b->raw->lights[i];
    const double *given = raw->direction ? raw->direction : raw->position;
    char path[RL_YAML_KEY_MAX];
    snprintf(path, sizeof path, "lights[%zu].%s", i, raw->direction ? "direction" : "position");
    int status = rl_build_triple(b, path, given, -RL_LENGTH_MAX, RL_LENGTH_MAX);
    if (status != RL_OK)
        return status;
    source->parallel = raw->direction != NULL;
    source->at = v3(given[0], given[1], given[2]);
    if (!source->parallel)
        return RL_OK;
    source->at = v3_normalize(v3_scale(-1.0, source->at));
    if (!(v3_length(source->at) > 0.0))
        return rl_yaml_fail(b->tree, b->error, path, "found the zero vector, expected where the light goes");
    return RL_OK;
}
