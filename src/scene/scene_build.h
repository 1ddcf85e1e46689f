/* The steps from a scene file as written to a struct rl_scene, shared by the files that carry them out. */
#ifndef RL_SCENE_SCENE_BUILD_H
#define RL_SCENE_SCENE_BUILD_H

#include <stdbool.h>

#include "scene/scene.h"
#include "scene/scene_schema.h"

struct rl_scene_builder {
    const struct rl_raw_scene *raw;
    const struct rl_yaml_tree *tree; /* for messages */
    struct rl_scene *scene;
    struct rl_error *error;
};

/* Of radiance and of colours that may be above 1. */
#define RL_COLOUR_MAX 1e9

/* Whether `value`, found at the key, is in [low, high]. */
int rl_build_range(const struct rl_scene_builder *b, const char *key, double value, double low, double high);
/* The same for all of three entries. */
int rl_build_triple(const struct rl_scene_builder *b, const char *key, const double value[3], double low,
                    double high);
/* Whether the file has the key, with whatever value: libcyaml gives NULL for an empty list, too. */
bool rl_build_has_key(const struct rl_scene_builder *b, const char *parent, const char *key);

/* scene_camera.c. The planes want the objects. */
int rl_build_camera(const struct rl_scene_builder *b);
int rl_build_camera_planes(const struct rl_scene_builder *b);

/* scene_objects.c */
int rl_build_objects(const struct rl_scene_builder *b);

/* scene_lights.c */
int rl_build_lights(const struct rl_scene_builder *b);

/* scene_sources.c: which kind of light lights[i] is, told from its keys. */
enum rl_light_kind { RL_LIGHT_POLYGON, RL_LIGHT_MESH, RL_LIGHT_POINT, RL_LIGHT_PARALLEL };
/* RL_ERR_INPUT: several kinds at once or none, a placement of what has no shape. */
int rl_build_light_kind(const struct rl_scene_builder *b, size_t i, enum rl_light_kind *kind);
const char *rl_light_kind_key(enum rl_light_kind kind);
/* A point or parallel light, without its strength. */
int rl_build_source(const struct rl_scene_builder *b, size_t i, struct rl_source *source);

/* scene_strength.c. The scene's `white`, before anything that it divides; RL_ERR_INPUT: radiometric and photometric lights. */
int rl_build_white(const struct rl_scene_builder *b);
/* The radiance of a light whose shape is built already; light NULL: of one without shape, its intensity or irradiance.
 * RL_ERR_INPUT: no quantity that goes with the kind of light, or more than one; a wrong unit; a value out of range. */
int rl_build_strength(const struct rl_scene_builder *b, size_t i, enum rl_light_kind kind,
                      const struct rl_light *light, double rgb[3]);

/* placement.c: a vertex goes to linear p + translate, a normal to cofactor n (the inverse transpose, times
 * the determinant, which is positive). */
struct rl_placement {
    double linear[3][3], cofactor[3][3];
    rl_vec3 translate;
    bool is_identity; /* nothing was asked for: meshes are left as they are */
};

int rl_build_placement(struct rl_placement *placement, const struct rl_scene_builder *b,
                       const struct rl_raw_placement *raw, const char *key);
rl_vec3 rl_place_point(const struct rl_placement *placement, rl_vec3 p);
void rl_place_mesh(const struct rl_placement *placement, struct rl_mesh *mesh);
/* Whether what was placed lies within RL_LENGTH_MAX of the origin. */
int rl_build_extent(const struct rl_scene_builder *b, const char *key, rl_vec3 centre, double radius);

/* Loads the mesh that the scene file names at `key`, relative to its own folder, and takes it into the
 * scene's hash. */
int rl_build_mesh_file(const struct rl_scene_builder *b, struct rl_mesh *mesh, const char *file,
                       const char *key);

#endif
