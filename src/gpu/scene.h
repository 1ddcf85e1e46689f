/* A scene prepared on the GPU, as the files of this folder share it (gpu.h is what others see). */
#ifndef RL_GPU_SCENE_H
#define RL_GPU_SCENE_H

#include "gpu/context.h"
#include "gpu/gpu.h"
#include "gpu/program.h"

/* Binding points; the shaders name the same numbers. */
enum { RL_UNIT_ENVIRONMENT, RL_UNIT_NORMAL_MAP };                               /* textures */
enum { RL_BLOCK_LIGHTS, RL_BLOCK_PATTERN, RL_BLOCK_SPHERES, RL_BLOCK_SOURCES }; /* uniform buffers */
enum { RL_STORE_POLYGONS, RL_STORE_POLYGON_VERTICES };                          /* shader storage */

struct rl_gpu_object {
    GLuint vertex_array;
    GLuint part[RL_MESH_PARTS]; /* buffers: its own, or those of the objects that the plan names */
    GLsizei n_indices;
    size_t n_back_faces; /* from where the camera was when the scene was made */
    const struct rl_plan_material *material;
    GLuint environment; /* cube map or 0 */
};

/* What a material sets before each draw. */
struct rl_gpu_material {
    float specular[3];
    float effect_params[RL_PLAN_EFFECTS_MAX][RL_EFFECT_PARAMS][4];
    float method_params[RL_EFFECT_PARAMS][4];
};

/* The lights; 0 what the plan has no use for. */
struct rl_gpu_lights {
    GLuint vertex_array, vertex_buffer;
    GLsizei n_vertices;
    GLuint points, spheres, sources;   /* uniform buffers */
    GLuint polygons, polygon_vertices; /* shader storage */
};

struct rl_gpu_scene {
    struct rl_gpu *gpu;
    const struct rl_scene *scene;
    const struct rl_plan *plan;
    int width, height;
    GLuint framebuffer, colour, depth; /* depth: and stencil, where the plan has one */
    struct rl_gpu_program *program;    /* plan->n_programs */
    struct rl_gpu_material *material;  /* plan->n_materials */
    struct rl_gpu_object *object;      /* scene->n_objects */
    GLuint *normal_map;                /* plan->n_normal_maps */
    GLuint *pattern;                   /* plan->n_patterns */
    GLuint *environment;               /* plan->n_environments */
    struct rl_gpu_lights lights;
    GLuint environment_framebuffer, environment_depth;
    float environment_unit;
    struct rl_gpu_counters counters;
};

/* passes.c: the frame buffer cleared, and what all of a frame's draws have in common set. Then an object's draw. */
void rl_frame_begin(const struct rl_gpu_scene *gs);
void rl_frame_set_camera(const struct rl_gpu_scene *gs, const struct rl_gpu_program *p);
void rl_frame_draw_mesh(struct rl_gpu_scene *gs, const struct rl_gpu_object *object);

/* lights.c: checks that the lights are not too many, fills their buffers from the scene's present state, binds them. */
int rl_lights_make(struct rl_gpu_scene *gs, struct rl_error *error);
int rl_lights_fill(struct rl_gpu_scene *gs, struct rl_error *error);
void rl_lights_bind(const struct rl_gpu_scene *gs);
void rl_lights_free(struct rl_gpu_scene *gs);
/* The cube maps of the objects that need one, not drawn yet. */
int rl_environments_make(struct rl_gpu_scene *gs, struct rl_error *error);
void rl_environments_free(struct rl_gpu_scene *gs);

#endif
