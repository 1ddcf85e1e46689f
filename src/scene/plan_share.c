/* What objects have in common: parts of their meshes, and the point that environment maps are seen from.
 *
 * Meshes are in world space, rounded once, from double precision. A model matrix for the GPU would let copies of one shape share all of a
 * mesh, but would place vertices in single precision: elsewhere than the CPU's, by last bits. So a part is shared where it is the same after
 * placement: indices between all copies of a shape, normals between those that are not turned or stretched against each other, positions
 * only at one place. */
#include <stdbool.h>
#include <string.h>

#include "scene/plan_build.h"

static bool same_point(rl_vec3 a, rl_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Nothing else of a map is the object's. */
static int environment_of(struct rl_plan *plan, const struct rl_scene *scene, size_t object)
{
    for (size_t i = 0; i < object; i++)
        if (plan->environment[i] >= 0 && same_point(scene->object[i].centre, scene->object[object].centre))
            return plan->environment[i];
    return (int)plan->n_environments++;
}

void rl_plan_share_environments(struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_plan_material *m = rl_plan_of_object(plan, scene, i);
        bool needed =
            plan->object[i].drawn && m->method && m->method->needs_environment && plan->object[i].highlit;
        plan->environment[i] = needed ? environment_of(plan, scene, i) : -1;
    }
}

/* ---- Meshes ---- */

bool rl_plan_facets(const struct rl_plan *plan, const struct rl_scene *scene, size_t object)
{
    return rl_plan_of_object(plan, scene, object)->interpolation == RL_INTERPOLATION_CONSTANT;
}

static bool same_triangles(const struct rl_mesh *a, const struct rl_mesh *b)
{
    return a->n_vertices == b->n_vertices && a->n_triangles == b->n_triangles &&
           memcmp(a->triangle, b->triangle, a->n_triangles * sizeof *a->triangle) == 0;
}

static bool same_vectors(const float (*a)[3], const float (*b)[3], size_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

/* What of `object` is the same as that of the one before it whose triangles are. What facets have more follows from positions and triangles;
 * which vertices they have twice, from triangles. */
static void share_mesh(struct rl_plan *plan, const struct rl_scene *scene, size_t object)
{
    const struct rl_mesh *mesh = &scene->object[object].mesh;
    size_t *from = plan->object[object].mesh_from;
    for (size_t i = 0; i < object; i++) {
        const struct rl_mesh *other = &scene->object[i].mesh;
        if (!plan->object[i].drawn || rl_plan_facets(plan, scene, i) != rl_plan_facets(plan, scene, object) ||
            !same_triangles(mesh, other))
            continue;
        if (from[RL_MESH_TRIANGLES] == object)
            from[RL_MESH_TRIANGLES] = i;
        if (from[RL_MESH_NORMALS] == object &&
            same_vectors((const float(*)[3])mesh->normal, (const float(*)[3])other->normal, mesh->n_vertices))
            from[RL_MESH_NORMALS] = i;
        if (from[RL_MESH_POSITIONS] == object &&
            same_vectors((const float(*)[3])mesh->position, (const float(*)[3])other->position,
                         mesh->n_vertices))
            from[RL_MESH_POSITIONS] = i;
    }
}

void rl_plan_share_meshes(struct rl_plan *plan, const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++) {
        for (int part = 0; part < RL_MESH_PARTS; part++)
            plan->object[i].mesh_from[part] = i;
        if (plan->object[i].drawn)
            share_mesh(plan, scene, i);
    }
}
