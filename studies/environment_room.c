/* Whether there is room for an object to grow: the lights come as near to it as `away` says (see environment.h). */
#include <float.h>
#include <math.h>

#include "results/record.h"
#include "studies/environment.h"

static double to_segment(rl_vec3 p, rl_vec3 a, rl_vec3 b)
{
    rl_vec3 along = v3_sub(b, a);
    double t = v3_dot(v3_sub(p, a), along) / fmax(v3_dot(along, along), DBL_MIN);
    return v3_length(v3_sub(p, v3_madd(a, fmin(fmax(t, 0.0), 1.0), along)));
}

/* To the plane where the point's foot is inside of the triangle, else to the nearest edge. */
static double to_triangle(rl_vec3 p, const rl_vec3 v[3], rl_vec3 normal)
{
    double nearest = INFINITY;
    bool inside = true;
    for (int i = 0; i < 3; i++) {
        rl_vec3 a = v[i], b = v[(i + 1) % 3];
        inside = inside && v3_dot(v3_cross(v3_sub(b, a), v3_sub(p, a)), normal) >= 0.0;
        nearest = fmin(nearest, to_segment(p, a, b));
    }
    return inside ? fabs(v3_dot(v3_sub(p, v[0]), normal)) : nearest;
}

/* From the point to the light, of which every vertex is `away` times as far from `centre`. */
static double to_light(rl_vec3 p, const struct rl_light *light, rl_vec3 centre, double away)
{
    double nearest = INFINITY;
    for (size_t k = 0; k < light->n_polygons; k++) {
        const struct rl_polygon *polygon = &light->polygon[k];
        for (int t = 0; t < polygon->n - 2; t++) {
            rl_vec3 v[3];
            for (int i = 0; i < 3; i++)
                v[i] = v3_madd(centre, away, v3_sub(polygon->vertex[polygon->triangle[t][i]], centre));
            nearest = fmin(nearest, to_triangle(p, v, polygon->normal));
        }
    }
    return nearest;
}

int rl_environment_check(const char *parameters, const struct rl_scene *scene, struct rl_error *error)
{
    double away = rl_parameter_number(parameters, "away");
    if (!(away < 1.0) || scene->n_objects == 0)
        return RL_OK;
    rl_vec3 centre = scene->object[rl_environment_object(scene)].centre;
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_object *object = &scene->object[i];
        if (!scene->material[object->material].method)
            continue;
        for (size_t k = 0; k < scene->n_lights; k++) {
            double distance = to_light(object->centre, &scene->light[k], centre, away);
            if (distance <= object->radius)
                return rl_fail(
                    error, RL_ERR_INPUT,
                    "found away=%g, where the object '%s' of radius %.3g meets the light '%s', then at "
                    "%.3g from its centre; expected a larger one",
                    away, object->name ? object->name : "", object->radius,
                    scene->light[k].name ? scene->light[k].name : "", distance);
        }
    }
    return RL_OK;
}
