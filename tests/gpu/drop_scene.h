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

static inline bool dropped(const struct rl_plan *plan, const char *kind, const char *name, const char *reason)
{
    for (size_t i = 0; i < plan->n_drops; i++)
        if (strcmp(plan->drop[i].kind, kind) == 0 && strcmp(plan->drop[i].name, name) == 0)
            return strstr(plan->drop[i].reason, reason) != NULL;
    return false;
}

#endif
