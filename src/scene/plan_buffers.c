/* Which buffers of lights a plan needs: those that some program or environment map of it reads. */
#include "scene/plan.h"

static bool some_material_has_spheres(const struct rl_plan *plan)
{
    for (size_t i = 0; i < plan->n_materials; i++)
        if (plan->material[i].sphere_program >= 0)
            return true;
    return false;
}

static bool some_material_sees_points(const struct rl_plan *plan)
{
    for (size_t i = 0; i < plan->n_materials; i++)
        if (plan->material[i].n_point_lights > 0)
            return true;
    return false;
}

bool rl_plan_needs(const struct rl_plan *plan, enum rl_plan_buffer buffer)
{
    if (plan->on_cpu)
        return false;
    switch (buffer) {
    case RL_BUFFER_TRIANGLES:
        return plan->n_environments > 0;
    case RL_BUFFER_POINTS:
        return some_material_sees_points(plan);
    case RL_BUFFER_SPHERES:
        return some_material_has_spheres(plan);
    case RL_BUFFER_SOURCES:
        return plan->sees & RL_SEES_SOURCES;
    case RL_BUFFER_POLYGONS:
        return plan->sees & RL_SEES_POLYGONS;
    default:
        return false;
    }
}

const char *rl_plan_buffer_name(enum rl_plan_buffer buffer)
{
    static const char *const name[RL_BUFFERS] = {
        [RL_BUFFER_TRIANGLES] = "light triangles", [RL_BUFFER_POINTS] = "light points",
        [RL_BUFFER_SPHERES] = "light spheres",     [RL_BUFFER_SOURCES] = "point and parallel lights",
        [RL_BUFFER_POLYGONS] = "light polygons",
    };
    return name[buffer];
}
