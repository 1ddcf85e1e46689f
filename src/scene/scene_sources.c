/* Kinds of lights in a scene file, and those without shape: points and parallel light. */
#include <stdio.h>
#include <string.h>

#include "scene/scene_build.h"

/* By enum rl_light_kind: the key that tells it, and the quantity that its strength is. */
static const struct {
    const char *key, *strength;
} kinds[] = {
    {"polygon", "radiance"}, {"mesh", "radiance"}, {"position", "intensity"}, {"direction", "irradiance"}};
enum { N_KINDS = sizeof kinds / sizeof kinds[0] };

/* In the tree, since libcyaml gives NULL for an empty list, too. */
static bool has_key(const struct rl_scene_builder *b, const char *light, const char *key)
{
    char path[RL_YAML_KEY_MAX];
    rl_yaml_key(path, light, key);
    return rl_yaml_find(b->tree, path) != NULL;
}

static int find_kind(const struct rl_scene_builder *b, const char *key, enum rl_light_kind *kind)
{
    int found = -1;
    for (int i = 0; i < N_KINDS; i++) {
        if (!has_key(b, key, kinds[i].key))
            continue;
        if (found >= 0)
            return rl_yaml_fail(b->tree, b->error, key, "found %s and %s, expected one of them",
                                kinds[found].key, kinds[i].key);
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
        if (has_key(b, key, placements[i])) {
            rl_yaml_key(path, key, placements[i]);
            return rl_yaml_fail(b->tree, b->error, path,
                                "found it with %s, expected only with polygon or mesh", kinds[kind].key);
        }
    return RL_OK;
}

int rl_build_light_kind(const struct rl_scene_builder *b, size_t i, enum rl_light_kind *kind,
                        double strength[3])
{
    const struct rl_raw_light *raw = &b->raw->lights[i];
    const struct {
        const char *key;
        const double *value;
    } strengths[] = {
        {"radiance", raw->radiance}, {"intensity", raw->intensity}, {"irradiance", raw->irradiance}};
    char key[RL_YAML_KEY_MAX], path[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "lights[%zu]", i);
    int status = find_kind(b, key, kind);
    if (status == RL_OK && (*kind == RL_LIGHT_POINT || *kind == RL_LIGHT_PARALLEL))
        status = check_placement(b, key, *kind);
    for (size_t k = 0; k < sizeof strengths / sizeof strengths[0] && status == RL_OK; k++) {
        rl_yaml_key(path, key, strengths[k].key);
        bool right = strcmp(strengths[k].key, kinds[*kind].strength) == 0;
        if (right && !strengths[k].value)
            return rl_yaml_fail_value(b->tree, b->error, path, "a list of 3");
        if (!right && strengths[k].value)
            return rl_yaml_fail(b->tree, b->error, path, "found it with %s, expected %s", kinds[*kind].key,
                                kinds[*kind].strength);
        if (!right)
            continue;
        memcpy(strength, strengths[k].value, 3 * sizeof *strength);
        status = rl_build_triple(b, path, strength, 0.0, RL_COLOUR_MAX);
    }
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
