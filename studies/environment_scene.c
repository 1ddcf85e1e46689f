/* Scenes whose lights are moved away and which are turned as a whole (see environment.h). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "studies/environment.h"

/* Rows of an orthonormal matrix. */
struct turn {
    rl_vec3 row[3];
};

static rl_vec3 turned(const struct turn *t, rl_vec3 v)
{
    return v3(v3_dot(t->row[0], v), v3_dot(t->row[1], v), v3_dot(t->row[2], v));
}

/* The turn of the unit vector `from` to the unit vector `to`, about their cross product (Rodrigues): I + [w] + [w]^2/(1 + c). */
static struct turn turn_to(rl_vec3 from, rl_vec3 to)
{
    rl_vec3 w = v3_cross(from, to);
    double c = v3_dot(from, to), k = 1.0 / fmax(1.0 + c, 1e-12);
    return (struct turn){{v3(c + k * w.x * w.x, k * w.x * w.y - w.z, k * w.x * w.z + w.y),
                          v3(k * w.x * w.y + w.z, c + k * w.y * w.y, k * w.y * w.z - w.x),
                          v3(k * w.x * w.z - w.y, k * w.y * w.z + w.x, c + k * w.z * w.z)}};
}

size_t rl_environment_object(const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        if (scene->material[scene->object[i].material].method)
            return i;
    return 0;
}

static void *copy_of(const void *data, size_t n, size_t size)
{
    void *copy = calloc(n ? n : 1, size);
    if (copy && n)
        memcpy(copy, data, n * size);
    return copy;
}

/* Copies of all that will be changed; triangles stay the original's. On an error what was copied is freed by the caller, which
 * needs pointers that are NULL or owned. */
static int copy_arrays(struct rl_scene *copy, const struct rl_scene *scene, struct rl_error *error)
{
    bool full = true;
    copy->material = copy_of(scene->material, scene->n_materials, sizeof *scene->material);
    copy->object = copy_of(scene->object, scene->n_objects, sizeof *scene->object);
    copy->light = copy_of(scene->light, scene->n_lights, sizeof *scene->light);
    for (size_t i = 0; copy->object && i < scene->n_objects; i++) {
        struct rl_mesh *mesh = &copy->object[i].mesh;
        mesh->position = copy_of(mesh->position, mesh->n_vertices, sizeof *mesh->position);
        mesh->normal = copy_of(mesh->normal, mesh->n_vertices, sizeof *mesh->normal);
        full = full && mesh->position && mesh->normal;
    }
    for (size_t i = 0; copy->light && i < scene->n_lights; i++) {
        struct rl_light *light = &copy->light[i];
        light->polygon = copy_of(light->polygon, light->n_polygons, sizeof *light->polygon);
        full = full && light->polygon;
        for (size_t k = 0; light->polygon && k < light->n_polygons; k++) {
            struct rl_polygon *p = &light->polygon[k];
            p->vertex = copy_of(p->vertex, (size_t)p->n, sizeof *p->vertex);
            full = full && p->vertex;
        }
    }
    if (!copy->material || !copy->object || !copy->light || !full)
        return rl_fail_memory(error, "a copy of the scene");
    return RL_OK;
}

static void move_light(struct rl_light *light, rl_vec3 centre, double away, const struct turn *t)
{
    for (size_t k = 0; k < light->n_polygons; k++) {
        struct rl_polygon *p = &light->polygon[k];
        for (int i = 0; i < p->n; i++)
            p->vertex[i] = turned(t, v3_madd(centre, away, v3_sub(p->vertex[i], centre)));
        p->normal = turned(t, p->normal);
        p->area *= away * away;
    }
    light->normal = turned(t, light->normal);
    light->centroid = turned(t, v3_madd(centre, away, v3_sub(light->centroid, centre)));
    light->centre = turned(t, v3_madd(centre, away, v3_sub(light->centre, centre)));
    light->radius *= away;
    light->area *= away * away;
}

static void turn_floats(float (*value)[3], size_t n, const struct turn *t)
{
    for (size_t i = 0; i < n; i++) {
        rl_vec3 v = turned(t, v3(value[i][0], value[i][1], value[i][2]));
        value[i][0] = (float)v.x;
        value[i][1] = (float)v.y;
        value[i][2] = (float)v.z;
    }
}

static void move_scene(struct rl_scene *copy, const struct rl_environment_move *move, const struct turn *t)
{
    rl_vec3 centre = copy->object[rl_environment_object(copy)].centre;
    for (size_t i = 0; i < copy->n_lights; i++)
        move_light(&copy->light[i], centre, move->away, t);
    for (size_t i = 0; i < copy->n_objects; i++) {
        struct rl_object *object = &copy->object[i];
        turn_floats(object->mesh.position, object->mesh.n_vertices, t);
        turn_floats(object->mesh.normal, object->mesh.n_vertices, t);
        object->centre = turned(t, object->centre);
    }
    struct rl_camera *c = &copy->camera;
    c->position = turned(t, c->position);
    c->right = turned(t, c->right);
    c->up = turned(t, c->up);
    c->forward = turned(t, c->forward);
    for (size_t i = 0; i < copy->n_materials; i++)
        memset(copy->material[i].effect, 0, sizeof copy->material[i].effect);
}

int rl_environment_scene_make(struct rl_scene *copy, const struct rl_scene *scene,
                              const struct rl_environment_move *move, struct rl_error *error)
{
    *copy = *scene;
    if (scene->n_lights == 0 || scene->n_objects == 0) {
        *copy = (struct rl_scene){0};
        return rl_fail(error, RL_ERR_INPUT, "%s: found no light or no object, expected both", scene->path);
    }
    int status = copy_arrays(copy, scene, error);
    if (status != RL_OK) {
        rl_environment_scene_free(copy);
        return status;
    }
    char key[128];
    int n = snprintf(key, sizeof key, "away=%.17g direction=%.17g,%.17g,%.17g", move->away, move->direction.x,
                     move->direction.y, move->direction.z);
    copy->hash = rl_hash_bytes(scene->hash, key, (size_t)n);
    struct turn t = {{v3(1.0, 0.0, 0.0), v3(0.0, 1.0, 0.0), v3(0.0, 0.0, 1.0)}};
    if (v3_length(move->direction) > 0.0) {
        rl_vec3 from = v3_sub(scene->light[0].centre, scene->object[rl_environment_object(scene)].centre);
        t = turn_to(v3_normalize(from), v3_normalize(move->direction));
        for (size_t i = 1; i < copy->n_lights; i++)
            memset(copy->light[i].radiance, 0, sizeof copy->light[i].radiance);
    }
    move_scene(copy, move, &t);
    return RL_OK;
}

void rl_environment_scene_free(struct rl_scene *copy)
{
    for (size_t i = 0; copy->object && i < copy->n_objects; i++) {
        free(copy->object[i].mesh.position);
        free(copy->object[i].mesh.normal);
    }
    for (size_t i = 0; copy->light && i < copy->n_lights; i++) {
        for (size_t k = 0; copy->light[i].polygon && k < copy->light[i].n_polygons; k++)
            free(copy->light[i].polygon[k].vertex);
        free(copy->light[i].polygon);
    }
    free(copy->material);
    free(copy->object);
    free(copy->light);
    *copy = (struct rl_scene){0};
}
