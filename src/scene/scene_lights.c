/* The lights of a scene file that have a shape: polygons, or the triangles of a mesh, with their centroid and bounding
 * sphere; scene_sources.c has the others. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/scene_build.h"

/* What a flat mesh may be out of its plane: a part of its radius, as polygons may, and of where it is, for its vertices are in single
 * precision. */
#define FLAT 1e-6
#define ROUNDED 2.4e-7

static int build_polygon(const struct rl_scene_builder *b, struct rl_light *light,
                         const struct rl_raw_light *raw, const struct rl_placement *placement,
                         const char *key)
{
    char path[RL_YAML_KEY_MAX];
    rl_vec3 vertex[RL_POLYGON_VERTICES_MAX];
    for (unsigned i = 0; i < raw->n_polygon && i < RL_POLYGON_VERTICES_MAX; i++) {
        snprintf(path, sizeof path, "%.100s.polygon[%u]", key, i);
        int status = rl_build_triple(b, path, raw->polygon[i], -RL_LENGTH_MAX, RL_LENGTH_MAX);
        if (status != RL_OK)
            return status;
        vertex[i] = rl_place_point(placement, v3(raw->polygon[i][0], raw->polygon[i][1], raw->polygon[i][2]));
    }
    light->polygon = calloc(1, sizeof *light->polygon);
    if (!light->polygon)
        return rl_fail_memory(b->error, key);
    struct rl_error polygon_error;
    int status = rl_polygon_make(light->polygon, vertex, (int)raw->n_polygon, &polygon_error);
    if (status == RL_OK) {
        light->n_polygons = 1;
        return RL_OK;
    }
    if (status != RL_ERR_INPUT)
        return rl_fail(b->error, polygon_error.status, "%s", polygon_error.message);
    rl_yaml_key(path, key, "polygon");
    return rl_yaml_fail(b->tree, b->error, path, "%s", polygon_error.message);
}

static rl_vec3 corner(const struct rl_mesh *mesh, size_t triangle, int i)
{
    const float *p = mesh->position[mesh->triangle[triangle][i]];
    return v3(p[0], p[1], p[2]);
}

/* Triangles without area give no light and are left out. */
static int take_triangles(struct rl_light *light, const struct rl_mesh *mesh, struct rl_error *error)
{
    light->polygon = calloc(mesh->n_triangles, sizeof *light->polygon);
    if (!light->polygon)
        return rl_fail_memory(error, "a light");
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        const rl_vec3 vertex[3] = {corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2)};
        int status = rl_polygon_make(&light->polygon[light->n_polygons], vertex, 3, error);
        if (status == RL_OK)
            light->n_polygons++;
        else if (status != RL_ERR_INPUT)
            return status;
    }
    return RL_OK;
}

static int build_mesh(const struct rl_scene_builder *b, struct rl_light *light,
                      const struct rl_raw_light *raw, const struct rl_placement *placement, const char *key)
{
    char path[RL_YAML_KEY_MAX];
    rl_yaml_key(path, key, "mesh");
    struct rl_mesh mesh = {0};
    int status = rl_build_mesh_file(b, &mesh, raw->mesh, path);
    if (status == RL_OK) {
        rl_place_mesh(placement, &mesh);
        status = take_triangles(light, &mesh, b->error);
    }
    rl_mesh_clear(&mesh);
    if (status == RL_OK && light->n_polygons == 0)
        return rl_yaml_fail(b->tree, b->error, path, "found a mesh of zero area, expected an area above 0");
    return status;
}

/* ---- Centroid and bounding sphere ---- */

static void measure(struct rl_light *light)
{
    rl_vec3 moment = v3(0.0, 0.0, 0.0);
    double area = 0.0;
    for (size_t i = 0; i < light->n_polygons; i++) {
        const struct rl_polygon *p = &light->polygon[i];
        for (int t = 0; t < p->n - 2; t++) {
            rl_vec3 a = p->vertex[p->triangle[t][0]], b = p->vertex[p->triangle[t][1]],
                    c = p->vertex[p->triangle[t][2]];
            double part = 0.5 * v3_length(v3_cross(v3_sub(b, a), v3_sub(c, a)));
            moment = v3_madd(moment, part / 3.0, v3_add(a, v3_add(b, c)));
            area += part;
        }
    }
    light->centroid = v3_scale(1.0 / area, moment);
    light->area = light->n_polygons == 1 ? light->polygon[0].area : area;
}

/* Whether every corner of a mesh is in one plane, and the plane's normal. Which way round triangles are listed does not matter, since they
 * shine from both sides: each is turned to agree with those before it. */
static bool is_flat(const struct rl_light *light, rl_vec3 *normal)
{
    rl_vec3 sum = v3(0.0, 0.0, 0.0);
    for (size_t i = 0; i < light->n_polygons; i++) {
        const struct rl_polygon *p = &light->polygon[i];
        sum = v3_madd(sum, v3_dot(sum, p->normal) < 0.0 ? -p->area : p->area, p->normal);
    }
    *normal = v3_normalize(sum);
    const double most = FLAT * light->radius + ROUNDED * v3_length(light->centroid);
    for (size_t i = 0; i < light->n_polygons; i++)
        for (int k = 0; k < light->polygon[i].n; k++)
            if (fabs(v3_dot(*normal, v3_sub(light->polygon[i].vertex[k], light->centroid))) > most)
                return false;
    return true;
}

/* A closed mesh as a point: what a convex body shows on average. A flat one as a polygon of its outline. One that is neither shows, where it
 * does not hide itself, each triangle's area times the cosine of its own: half of the sum, on average over all directions. */
static int take_as_point(struct rl_light *light, struct rl_error *error)
{
    rl_vec3 normal;
    int status = rl_light_closed(&light->closed, light, error);
    if (status != RL_OK)
        return status;
    if (light->closed)
        light->area *= 0.25;
    else if (is_flat(light, &normal))
        light->normal = normal;
    else
        light->area *= 0.5;
    return RL_OK;
}

static rl_vec3 farthest(const struct rl_light *light, rl_vec3 from, double *distance)
{
    rl_vec3 best = from;
    *distance = 0.0;
    for (size_t i = 0; i < light->n_polygons; i++)
        for (int j = 0; j < light->polygon[i].n; j++) {
            double d = v3_length(v3_sub(light->polygon[i].vertex[j], from));
            if (d > *distance) {
                *distance = d;
                best = light->polygon[i].vertex[j];
            }
        }
    return best;
}

/* Badoiu and Clarkson 2003: steps of 1/(i + 1) towards the farthest point come within 1/sqrt(n) of the
 * smallest sphere's centre after n; in practice far closer. The best of all steps is kept, and it encloses
 * every vertex whatever it is. */
static void enclose(struct rl_light *light)
{
    /* Big meshes get fewer steps: the sphere is to be tight, not the tightest. */
    size_t steps = light->n_polygons < 2000 ? 500 : 20;
    rl_vec3 centre = light->centroid;
    light->radius = HUGE_VAL;
    for (size_t i = 1; i <= steps; i++) {
        double distance;
        rl_vec3 towards = farthest(light, centre, &distance);
        if (distance < light->radius) {
            light->radius = distance;
            light->centre = centre;
        }
        centre = v3_madd(centre, 1.0 / (double)(i + 1), v3_sub(towards, centre));
    }
}

static int name_light(char **name, const struct rl_scene_builder *b, size_t i)
{
    char key[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "lights[%zu]", i);
    *name = strdup(b->raw->lights[i].name ? b->raw->lights[i].name : key);
    return *name ? RL_OK : rl_fail_memory(b->error, key);
}

/* A light with a shape, without its radiance. */
static int build_shaped(const struct rl_scene_builder *b, size_t i, struct rl_light *light)
{
    const struct rl_raw_light *raw = &b->raw->lights[i];
    char key[RL_YAML_KEY_MAX];
    snprintf(key, sizeof key, "lights[%zu]", i);
    struct rl_placement placement;
    int status = rl_build_placement(&placement, b, &raw->placement, key);
    if (status == RL_OK)
        status = raw->mesh ? build_mesh(b, light, raw, &placement, key)
                           : build_polygon(b, light, raw, &placement, key);
    if (status != RL_OK)
        return status;
    measure(light);
    enclose(light);
    light->mesh = raw->mesh;
    if (light->mesh)
        status = take_as_point(light, b->error);
    if (status != RL_OK)
        return status;
    return rl_build_extent(b, key, light->centre, light->radius);
}

static int build_light(const struct rl_scene_builder *b, size_t i)
{
    enum rl_light_kind kind;
    struct rl_scene *scene = b->scene;
    int status = rl_build_light_kind(b, i, &kind);
    if (status != RL_OK)
        return status;
    if (kind == RL_LIGHT_POINT || kind == RL_LIGHT_PARALLEL) {
        struct rl_source *source = &scene->source[scene->n_sources++];
        status = name_light(&source->name, b, i);
        if (status == RL_OK)
            status = rl_build_source(b, i, source);
        return status == RL_OK ? rl_build_strength(b, i, kind, NULL, source->strength) : status;
    }
    struct rl_light *light = &scene->light[scene->n_lights++];
    status = name_light(&light->name, b, i);
    if (status == RL_OK)
        status = build_shaped(b, i, light);
    return status == RL_OK ? rl_build_strength(b, i, kind, light, light->radiance) : status;
}

int rl_build_lights(const struct rl_scene_builder *b)
{
    if (b->raw->n_lights == 0)
        return RL_OK;
    b->scene->light = calloc(b->raw->n_lights, sizeof *b->scene->light);
    b->scene->source = calloc(b->raw->n_lights, sizeof *b->scene->source);
    if (!b->scene->light || !b->scene->source)
        return rl_fail_memory(b->error, "the lights");
    for (size_t i = 0; i < b->raw->n_lights; i++) {
        int status = build_light(b, i);
        if (status != RL_OK)
            return status;
    }
    return RL_OK;
}
