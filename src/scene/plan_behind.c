/* Whether a light is below the horizon of a surface (see plan_build.h). Doubt says no: there is room for rounding in single precision. */
#include "scene/plan_build.h"

#include <math.h>

/* Room for rounding, in units of the lengths compared. */
#define SLACK RL_VIEW_SLACK
/* The same of places, in units of their coordinates: a few roundings to 24 bits. */
#define PLACES 1e-6

struct rl_plan_body rl_plan_body_of_light(const struct rl_light *light)
{
    struct rl_plan_body body = {.at = light->centre, .radius = light->radius};
    rl_vec3 low = v3(INFINITY, INFINITY, INFINITY), high = v3(-INFINITY, -INFINITY, -INFINITY);
    size_t n = 0;
    for (size_t i = 0; i < light->n_polygons; i++)
        for (int k = 0; k < light->polygon[i].n; k++, n++) {
            rl_vec3 x = light->polygon[i].vertex[k];
            low = v3(fmin(low.x, x.x), fmin(low.y, x.y), fmin(low.z, x.z));
            high = v3(fmax(high.x, x.x), fmax(high.y, x.y), fmax(high.z, x.z));
            if (n < RL_POLYGON_VERTICES_MAX)
                body.corner[n] = x;
        }
    body.n_corners = n <= RL_POLYGON_VERTICES_MAX ? n : 8;
    for (size_t i = 0; i < 8 && n > RL_POLYGON_VERTICES_MAX; i++)
        body.corner[i] = v3(i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z);
    return body;
}

static rl_vec3 position(const struct rl_mesh *mesh, size_t vertex)
{
    return v3(mesh->position[vertex][0], mesh->position[vertex][1], mesh->position[vertex][2]);
}

/* How far along N the body reaches beyond its centre. */
static double reach(const struct rl_plan_body *body, rl_vec3 N)
{
    double most = body->n_corners > 0 ? -body->radius : body->radius;
    for (size_t i = 0; i < body->n_corners; i++)
        most = fmax(most, v3_dot(N, v3_sub(body->corner[i], body->at)));
    return most;
}

/* N.(x - P) < 0 for every x of the body, each of which is a mean of its corners. `sine`: of the angle below the horizon that is asked for,
 * as seen from P at the distance of the farthest x. Places themselves are rounded, too, by a part of what they are from the origin. */
static bool below(const struct rl_plan_body *body, rl_vec3 P, rl_vec3 N, double sine)
{
    if (body->parallel)
        return v3_dot(N, body->at) <= -sine;
    rl_vec3 d = v3_sub(body->at, P);
    double height = v3_dot(N, d), rounding = PLACES * (v3_length(P) + v3_length(body->at) + body->radius),
           most = -sine * (v3_length(d) + body->radius) - rounding;
    return height + body->radius <= most || (height <= body->radius && height + reach(body, N) <= most);
}

/* Between vertices normal and point are weighted means of those at a triangle's corners, N = sum a_i N_i (before it is made a unit vector)
 * and P = sum a_j P_j, so that N.(x - P) is a mean of N_i.(x - P_j). */
bool rl_plan_behind(const struct rl_plan_body *body, const struct rl_object *object, double centre)
{
    const struct rl_mesh *mesh = &object->mesh;
    for (size_t t = 0; t < mesh->n_triangles; t++)
        for (int i = 0; i < 3; i++) {
            const float *n = mesh->normal[mesh->triangle[t][i]];
            rl_vec3 N = v3_normalize(v3(n[0], n[1], n[2]));
            if (centre >= 0.0 && !below(body, object->centre, N, centre))
                return false;
            for (int j = 0; j < 3; j++)
                if (!below(body, position(mesh, mesh->triangle[t][j]), N, SLACK))
                    return false;
        }
    return true;
}

bool rl_plan_behind_facets(const struct rl_plan_body *body, const struct rl_mesh *mesh)
{
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        rl_vec3 P, N;
        rl_mesh_facet(mesh, t, &P, &N);
        if (!below(body, P, N, SLACK))
            return false;
    }
    return true;
}
