/* A scene of which much cannot matter, for the tests of dropping on the GPU and on the CPU. */
#ifndef TESTS_GPU_DROP_SCENE_H
#define TESTS_GPU_DROP_SCENE_H

#include "gpu/fixture.h"

static inline void give(struct rl_material *material, const char *name, double first, double fourth)
{
    double *value = rl_effect_give(material, rl_effect_find(name));
    value[0] = value[1] = value[2] = first;
    value[3] = fourth;
    value[4] = 20.0;
}

/* A floor seen from above with lights of every kind above and below it, a ball in view and one beside the camera. */
static inline void begin_scene(struct rl_scene *scene, const char *method, bool ball)
{
    fixture_begin(scene, 64, 48);
    fixture_camera(scene, v3(0.0, 2.0, 5.0), v3(0.0, 0.0, 0.0), 30.0);
    int floor = fixture_material(scene, 20.0, 0.05, 0.5, 0.8, method);
    int paint = fixture_material(scene, 10.0, 0.05, 0.5, 0.8, method);
    fixture_material(scene, 10.0, 0.0, 0.5, 0.8, method); /* worn by nobody */
    scene->material[0].name = "floor";
    scene->material[1].name = "paint";
    scene->material[2].name = "spare";
    give(&scene->material[0], "phong", 0.4, 0.0);
    fixture_object(scene, RL_SHAPE_PLANE, 4, 2.0, v3(0.0, 0.0, 0.0), floor);
    scene->object[0].name = "floor";
    fixture_object(scene, RL_SHAPE_SPHERE, 8, 0.5, v3(3.0, 2.0, 5.0), paint);
    scene->object[1].name = "away";
    if (ball) {
        fixture_object(scene, RL_SHAPE_SPHERE, 8, 0.5, v3(0.5, 0.5, 0.0), paint);
        scene->object[2].name = "ball";
    }
    fixture_quad(scene, v3(-1.0, 1.5, -2.0), v3(0.6, 0.0, 0.0), v3(0.0, 0.6, 0.2), 2.0, 1.5, 1.0);
    fixture_quad(scene, v3(1.0, -1.5, -2.0), v3(0.6, 0.0, 0.0), v3(0.0, 0.6, 0.2), 7.0, 1.5, 1.0);
    fixture_source(scene, false, v3(1.0, 1.0, 1.0), 1.0, 1.0, 0.5);
    fixture_source(scene, false, v3(1.0, -1.0, 1.0), 5.0, 1.0, 0.5);
    fixture_source(scene, true, v3(0.3, 1.0, 0.2), 0.5, 0.5, 0.5);
    fixture_source(scene, true, v3(0.3, -1.0, 0.2), 3.0, 0.5, 0.5);
    fixture_source(scene, true, v3(0.3, 1.0, 0.2), 0.0, 0.0, 0.0);
    static char *const lights[] = {"high", "low"};
    static char *const sources[] = {"bulb", "cellar", "sun", "antipodes", "off"};
    for (size_t i = 0; i < sizeof lights / sizeof lights[0]; i++)
        scene->light[i].name = lights[i];
    for (size_t i = 0; i < sizeof sources / sizeof sources[0]; i++)
        scene->source[i].name = sources[i];
}

/* A floor with a bulb above it and a square below, or at a slant, whose bounding sphere reaches over the floor. */
struct drop_square {
    const char *method, *effect; /* or NULL */
    double y, slant;             /* its middle; how far one side is above that */
    int tessellation;            /* of a ball about it, with the square inside; 0: a floor */
    bool drops;
};

static const struct drop_square drop_squares[] = {
    {NULL, "diffuse", -1.0, 0.0, 0, true},
    {NULL, "diffuse-area", -1.0, 0.0, 0, true},
    {"plain", NULL, -1.0, 0.0, 0, true},
    {"random", NULL, -1.0, 0.0, 0, true},
    {"reference", NULL, -1.0, 0.0, 0, true},
    {NULL, "diffuse-area", -1e-3, 0.0, 0, true},
    {"reference", NULL, -1e-3, 0.0, 0, true},
    {NULL, "diffuse-area", -1.0, 0.9, 0, true},
    /* A corner above, or as good as on the floor; within two texels of the horizon of the map. */
    {NULL, "diffuse-area", -1.0, 1.1, 0, false},
    {"reference", NULL, -1.0, 1.1, 0, false},
    {NULL, "diffuse-area", 0.0, 0.0, 0, false},
    {NULL, "diffuse-area", -1e-6, 0.0, 0, false},
    {"random", NULL, -1e-3, 0.0, 0, false},
    /* Adds texels up in groups, which a light more may round otherwise. */
    {"exhaustive", NULL, -1.0, 0.0, 0, false},
    /* Inside of a ball, behind every facet; so coarse that its smooth normals see the corners. */
    {NULL, "diffuse-area", 0.0, 0.3, 24, true},
    {NULL, "diffuse-area", 0.0, 0.3, 4, false},
};

static inline void begin_square(struct rl_scene *scene, const struct drop_square *row)
{
    fixture_begin(scene, 48, 36);
    fixture_camera(scene, v3(0.0, 2.0, 6.0), v3(0.0, 0.5, 0.0), 40.0);
    int m = fixture_material(scene, 30.0, 0.0, 0.5, row->method ? 0.8 : 0.0, row->method);
    memset(scene->material[m].effect, 0, sizeof scene->material[m].effect);
    scene->material[m].name = "m";
    if (row->effect)
        rl_effect_give_colour(&scene->material[m], row->effect, 1.0, 0.9, 0.8);
    fixture_object(scene, row->tessellation ? RL_SHAPE_SPHERE : RL_SHAPE_PLANE,
                   row->tessellation ? row->tessellation : 4, row->tessellation ? 1.5 : 3.0,
                   v3(0.0, 0.0, 0.0), m);
    double half = row->tessellation ? 0.9 : 1.0;
    fixture_quad(scene, v3(0.0, row->y, 0.0), v3(half, 0.0, 0.0), v3(0.0, row->slant, half), 1.0, 1.5, 1.0);
    fixture_quad(scene, v3(0.0, 3.0, -1.0), v3(0.5, 0.0, 0.0), v3(0.0, 0.2, 0.5), 2.0, 1.5, 1.0);
    scene->object[0].name = "floor";
    scene->light[0].name = "square";
    scene->light[1].name = "above";
}

static inline bool dropped(const struct rl_plan *plan, const char *kind, const char *name, const char *reason)
{
    for (size_t i = 0; i < plan->n_drops; i++)
        if (strcmp(plan->drop[i].kind, kind) == 0 && strcmp(plan->drop[i].name, name) == 0)
            return strstr(plan->drop[i].reason, reason) != NULL;
    return false;
}

#endif
