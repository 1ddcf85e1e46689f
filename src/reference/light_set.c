/* Builds light sets (see light_set.h). */
#include "reference/light_set.h"

#include "model/plane.h"

#include <stdlib.h>

static int allocate(struct rl_light_set **out, size_t n_lights, size_t n_polygons, size_t n_vertices,
                    struct rl_error *error)
{
    struct rl_light_set *set = calloc(1, sizeof *set);
    if (!set)
        return rl_fail_memory(error, "the lights");
    set->grey = true;
    /* One element more than needed: calloc(0) may return NULL. */
    set->radiance = calloc(n_lights + 1, sizeof *set->radiance);
    set->polygon = calloc(n_polygons + 1, sizeof *set->polygon);
    set->vertex = calloc(n_vertices + 1, sizeof *set->vertex);
    set->edge = calloc(n_vertices + 1, sizeof *set->edge);
    if (!set->radiance || !set->polygon || !set->vertex || !set->edge) {
        rl_light_set_free(set);
        return rl_fail_memory(error, "the lights");
    }
    *out = set;
    return RL_OK;
}

void rl_light_set_free(struct rl_light_set *set)
{
    if (!set)
        return;
    free(set->radiance);
    free(set->polygon);
    free(set->vertex);
    free(set->edge);
    free(set->twin);
    free(set);
}

/* Index of this radiance, added if it is new. */
static size_t radiance_index(struct rl_light_set *set, const double radiance[3])
{
    for (size_t i = 0; i < set->n_radiances; i++)
        if (set->radiance[i][0] == radiance[0] && set->radiance[i][1] == radiance[1] &&
            set->radiance[i][2] == radiance[2])
            return i;
    for (int c = 0; c < 3; c++) {
        set->radiance[set->n_radiances][c] = radiance[c];
        set->brightest = fmax(set->brightest, radiance[c]);
        set->grey = set->grey && radiance[c] == radiance[0];
    }
    return set->n_radiances++;
}

/* Newell's method: the normal of the polygon nearest in the plane, whichever corners are nearly straight. */
static rl_vec3 newell(const rl_vec3 *vertex, size_t n)
{
    rl_vec3 sum = v3(0.0, 0.0, 0.0);
    for (size_t i = 1; i + 1 < n; i++)
        sum = v3_add(sum, v3_cross(v3_sub(vertex[i], vertex[0]), v3_sub(vertex[i + 1], vertex[0])));
    return v3_normalize(sum);
}

static void add_polygon(struct rl_light_set *set, const rl_vec3 *vertex, size_t n, const double radiance[3])
{
    struct rl_set_polygon polygon = {.first = set->n_vertices, .n = n, .normal = newell(vertex, n)};
    polygon.radiance = radiance_index(set, radiance);
    double size = 0.0, off = 0.0;
    for (size_t i = 0; i < n; i++) {
        rl_vec3 from_first = v3_sub(vertex[i], vertex[0]);
        set->vertex[set->n_vertices + i] = vertex[i];
        set->edge[set->n_vertices + i] = v3_sub(vertex[(i + 1) % n], vertex[i]);
        size = fmax(size, v3_length(from_first));
        off = fmax(off, fabs(v3_dot(polygon.normal, from_first)));
    }
    polygon.thickness = 2.0 * off + 4e-15 * size;
    polygon.most = rl_plane_most(vertex, n);
    set->polygon[set->n_polygons++] = polygon;
    set->n_vertices += n;
}

static int finish(struct rl_light_set **set, struct rl_error *error)
{
    (*set)->unit = RL_UNIT_DOUBLE;
    if ((*set)->n_polygons < 1 || (*set)->whole_polygons < 2 || (*set)->n_radiances > 1)
        return RL_OK;
    int status = rl_light_set_find_twins(*set, error);
    if (status != RL_OK) {
        rl_light_set_free(*set);
        *set = NULL;
    }
    return status;
}

static void count(size_t *n_polygons, size_t *n_vertices, const struct rl_light *light)
{
    *n_polygons += light->n_polygons;
    for (size_t j = 0; j < light->n_polygons; j++)
        *n_vertices += (size_t)light->polygon[j].n;
}

int rl_light_set_make_kept(struct rl_light_set **set, const struct rl_light *lights, size_t n_lights,
                           const size_t *kept, size_t n_kept, struct rl_error *error)
{
    size_t n_polygons = 0, n_vertices = 0, whole_polygons = 0, whole_vertices = 0;
    for (size_t i = 0; i < n_lights; i++)
        count(&whole_polygons, &whole_vertices, &lights[i]);
    for (size_t i = 0; i < n_kept; i++)
        count(&n_polygons, &n_vertices, &lights[kept[i]]);
    int status = allocate(set, n_lights, n_polygons, n_vertices, error);
    if (status != RL_OK)
        return status;
    (*set)->whole_polygons = whole_polygons;
    (*set)->whole_vertices = whole_vertices;
    for (size_t i = 0; i < n_lights; i++)
        if (lights[i].n_polygons > 0)
            radiance_index(*set, lights[i].radiance);
    for (size_t i = 0; i < n_kept; i++) {
        const struct rl_light *light = &lights[kept[i]];
        for (size_t j = 0; j < light->n_polygons; j++)
            add_polygon(*set, light->polygon[j].vertex, (size_t)light->polygon[j].n, light->radiance);
    }
    return finish(set, error);
}

int rl_light_set_make(struct rl_light_set **set, const struct rl_light *lights, size_t n_lights,
                      struct rl_error *error)
{
    size_t *all = malloc((n_lights + 1) * sizeof *all);
    if (!all)
        return rl_fail_memory(error, "the lights");
    for (size_t i = 0; i < n_lights; i++)
        all[i] = i;
    int status = rl_light_set_make_kept(set, lights, n_lights, all, n_lights, error);
    free(all);
    return status;
}

int rl_light_set_from_polygons(struct rl_light_set **set, const rl_vec3 *const vertices[],
                               const size_t n_vertices[], size_t n_polygons, struct rl_error *error)
{
    size_t n = 0;
    for (size_t i = 0; i < n_polygons; i++) {
        if (n_vertices[i] < 3)
            return rl_fail(error, RL_ERR_INPUT, "light polygon %zu has %zu vertices; expected 3 or more", i,
                           n_vertices[i]);
        for (size_t j = 0; j < n_vertices[i]; j++) {
            rl_vec3 v = vertices[i][j];
            if (!isfinite(v.x) || !isfinite(v.y) || !isfinite(v.z))
                return rl_fail(error, RL_ERR_INPUT, "light polygon %zu, vertex %zu: expected finite numbers",
                               i, j);
        }
        n += n_vertices[i];
    }
    int status = allocate(set, 1, n_polygons, n, error);
    if (status != RL_OK)
        return status;
    (*set)->whole_polygons = n_polygons;
    (*set)->whole_vertices = n;
    for (size_t i = 0; i < n_polygons; i++)
        add_polygon(*set, vertices[i], n_vertices[i], (const double[3]){1.0, 1.0, 1.0});
    return finish(set, error);
}
