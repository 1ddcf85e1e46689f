/* The plan: from a scene and settings, which effects are in use and, from that, the passes, textures and
 * shader modules that they need, in a fixed order. What the scene does not ask for is not in the plan, and
 * nothing outside the plan is allocated, compiled or drawn. `roughlight plan` prints it.
 */
#ifndef RL_SCENE_PLAN_H
#define RL_SCENE_PLAN_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "effects/effect.h"
#include "methods/method.h"
#include "scene/scene.h"
#include "scene/settings.h"

enum { RL_PLAN_EFFECTS_MAX = RL_MATERIAL_EFFECTS_MAX, RL_PLAN_MODULES_MAX = 32, RL_PLAN_MODULE_NAME = 48 };

/* One shader program. Module names are paths under shaders/ without ".glsl", e.g. "effects/diffuse". */
struct rl_plan_program {
    const char *pass; /* "environment", "surface", "sphere", "highlight" */
    int samples;      /* of the highlight pass, a constant of its shader; else 0 */
    /* The first n_vertex are the vertex shader, the rest together the fragment shader; the last of each holds its main(). */
    size_t n_modules, n_vertex;
    char module[RL_PLAN_MODULES_MAX][RL_PLAN_MODULE_NAME];
};

/* What the objects of one material need. */
struct rl_plan_material {
    int material;                   /* index in the scene */
    double rr;                      /* after overrides */
    const struct rl_method *method; /* NULL: no highlight */
    int samples;
    size_t n_effects;
    const struct rl_effect *effect[RL_PLAN_EFFECTS_MAX];
    enum rl_interpolation interpolation; /* phong where no effect sees a light */
    unsigned sees;                       /* enum rl_effect_sees: what of the scene's lights its effects see */
    int n_point_lights;                  /* 0 if nothing of this material asks for them */
    int n_points, n_parallels;           /* point and parallel lights that its effects see */
    int surface_program;   /* index; base shading, and the highlight too if the method takes no samples */
    int highlight_program; /* index or -1: the sampled highlight's own pass */
    int sphere_program;    /* index or -1: the bounding-sphere stencil */
    int normal_map;        /* index or -1 */
    int pattern;           /* index or -1 */
    double margin;         /* of the spheres, >= 0; with sphere_program */
};

/* A normal map is shared by all materials of one R_r, a pattern by all of one R_r and sample count. */
struct rl_plan_normal_map {
    double rr;
    const struct rl_method *method;
};
struct rl_plan_pattern {
    double rr;
    int samples;
    const struct rl_method *method;
};

/* What is uploaded of a mesh; `positions` with what triangles have that are shaded as a whole. */
enum rl_mesh_part { RL_MESH_TRIANGLES, RL_MESH_NORMALS, RL_MESH_POSITIONS, RL_MESH_PARTS };

struct rl_plan_object {
    bool drawn; /* false: outside the view */
    bool
        highlit; /* some shaped light is in front of its surface; false: the highlight's own passes leave it out */
    size_t mesh_from
        [RL_MESH_PARTS]; /* the first object whose part is the same, byte for byte: itself, if no other's before it is */
};

/* Why. Several may be one to a program that reads them: rl_plan_reason_code. */
enum rl_plan_reason {
    RL_WHY_NONE,
    RL_WHY_OUTSIDE_VIEW,
    RL_WHY_ONLY_SHADOW,
    RL_WHY_LIGHTS_BEHIND_OBJECT,
    RL_WHY_LIGHTS_BEHIND_WEARERS,
    RL_WHY_WEARERS_OUTSIDE_VIEW,
    RL_WHY_NOT_WORN,
    RL_WHY_NO_RADIANCE,
    RL_WHY_NO_STRENGTH,
    RL_WHY_BEHIND_SURFACES,
    RL_WHY_UNSEEN,
    RL_WHY_ZERO_COEFFICIENTS,
    RL_WHY_NO_HIGHLIGHT,
    RL_WHY_NO_LIGHT,
    RL_WHY_ZERO_SPECULAR,
    RL_WHY_ZERO_FACTOR,
    RL_WHY_NO_SHAPED_LIGHT,
    RL_WHY_LIGHTS_DARK,
    RL_WHY_TOO_ROUGH,
    RL_WHY_NO_PASS,
    RL_WHY_SINGLE_OBJECT,
    RL_WHY_NOTHING_TO_HIDE,
    RL_WHYS
};
/* "outside-view": for programs, and does not change. */
const char *rl_plan_reason_code(enum rl_plan_reason why);

/* What the scene has and the plan leaves out. */
struct rl_plan_drop {
    const char *kind; /* "object", "material", "light", "effect", "highlight", "highlight of object" */
    enum rl_plan_reason why;
    int material, object;       /* indices in the scene of what it is of, or is; -1: of none */
    char name[72], reason[160]; /* reason: in words */
};

struct rl_plan {
    struct rl_settings settings; /* with the scene's size filled in */
    unsigned sees;               /* enum rl_effect_sees: what of the lights any effect sees */
    bool stencil;                /* some pass needs a stencil buffer; false: none is allocated */
    bool
        on_cpu; /* some method is of the CPU alone, or shadows are on: no programs, textures or passes of the GPU */
    bool shadows; /* objects hide lights from one another */
    size_t n_materials, n_programs, n_normal_maps, n_patterns;
    struct rl_plan_material *material; /* those that some object wears, by index in the scene */
    struct rl_plan_program *program;
    struct rl_plan_normal_map *normal_map;
    struct rl_plan_pattern *pattern;
    size_t n_lights, n_sources;
    size_t n_points;               /* of the sources: point lights, which come first; the rest are parallel */
    size_t *light, *source;        /* indices in the scene of those that are not dropped */
    struct rl_plan_object *object; /* per object */
    size_t n_drops;
    struct rl_plan_drop *drop;
    size_t n_environments; /* cube maps */
    int *
        environment; /* per object: its cube map's index, in the order of first use, or -1; shared by objects of one centre */
    int environment_program; /* index or -1; on the CPU none is needed */
    /* The lights' brightest component, 1 if all are dark: unsigned texels hold radiance divided by it. */
    float radiance_scale;
};

/* With settings.drop, what cannot change a pixel of this scene, as it is now, is left out: after a light, an object or the camera has moved,
 * make another. RL_ERR_INPUT: settings out of range, a frame that a method does not take, materials whose methods share neither the CPU nor the
 * GPU, shadows that a method cannot draw, or a depth buffer of 16 bits where a pass needs a stencil, which these have none beside them. */
int rl_plan_make(struct rl_plan *plan, const struct rl_scene *scene, const struct rl_settings *settings,
                 struct rl_error *error);
void rl_plan_clear(struct rl_plan *plan);

/* Adds a module where the stage that is being put together does not have it yet (n_vertex is 0 until the vertex shader is complete); all that an effect with these values needs, itself the last. */
void rl_plan_add_module(struct rl_plan_program *program, const char *module);
void rl_plan_add_effect(struct rl_plan_program *program, const struct rl_effect *effect, const double *value);

/* Buffers that hold lights: triangles for environment maps; shaped lights as points; their bounding spheres; point and parallel lights; shaped
 * lights as polygons. */
enum rl_plan_buffer {
    RL_BUFFER_TRIANGLES,
    RL_BUFFER_POINTS,
    RL_BUFFER_SPHERES,
    RL_BUFFER_SOURCES,
    RL_BUFFER_POLYGONS,
    RL_BUFFERS
};
/* Whether anything reads it; no other is uploaded. */
bool rl_plan_needs(const struct rl_plan *plan, enum rl_plan_buffer buffer);
const char *rl_plan_buffer_name(enum rl_plan_buffer buffer);

/* The plan's shaped lights as effects see them (no sources); clear with rl_scene_lights_clear. And how many polygons they have. */
int rl_plan_lights_make(struct rl_lights *lights, const struct rl_plan *plan, const struct rl_scene *scene,
                        struct rl_error *error);
size_t rl_plan_polygons(const struct rl_plan *plan, const struct rl_scene *scene);

/* Whether an object that is drawn has vectors of its own for each triangle, which is shaded as a whole. */
bool rl_plan_facets(const struct rl_plan *plan, const struct rl_scene *scene, size_t object);

/* The plan of the material an object wears; NULL if no object that is drawn wears it. */
const struct rl_plan_material *rl_plan_of_object(const struct rl_plan *plan, const struct rl_scene *scene,
                                                 size_t object);

#endif
