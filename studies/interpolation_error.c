/* Errors of the study `interpolation`: the mesh against the exact surface, point by point (see interpolation.h). */
#include <math.h>
#include <stdlib.h>

#include "base/machine.h"
#include "reference/visible.h"
#include "studies/interpolation.h"

/* Of the mesh whose visible points are looked for: which points are taken hangs on it, their radiance does not. */
enum { FINE_SPHERE = 96, FINE_TEAPOT = 48 };

/* Points of the exact surface, and their radiance. */
struct truth {
    size_t n;
    struct rl_exact_point *point;
    double *radiance;
};

static void clear_truth(struct truth *t)
{
    free(t->point);
    free(t->radiance);
}

/* One for each pixel that shows the object. */
static int find_points(struct truth *t, struct rl_interpolation_case *c, const struct rl_visible *visible,
                       struct rl_error *error)
{
    int width = c->plan.settings.width, height = c->plan.settings.height;
    size_t most = (size_t)width * (size_t)height;
    *t = (struct truth){.point = calloc(most, sizeof *t->point),
                        .radiance = calloc(most, sizeof *t->radiance)};
    if (!t->point || !t->radiance)
        return rl_fail_memory(error, "points of the surface");
    for (size_t pixel = 0; pixel < most; pixel++) {
        struct rl_surface surface;
        struct rl_visible_hit hit;
        int x = (int)(pixel % (size_t)width), y = (int)(pixel / (size_t)width);
        if (!rl_visible_point(&surface, &hit, visible, rl_camera_ray(&c->scene.camera, width, height, x, y)))
            continue;
        struct rl_mesh_point at = {hit.triangle, {hit.weight[0], hit.weight[1], hit.weight[2]}};
        struct rl_exact_point *p = &t->point[t->n];
        rl_exact_from_mesh(p, c->object, &c->scene.object[0].mesh, c->tessellation, &at);
        t->radiance[t->n++] = rl_interpolation_radiance(c, p->P, p->N);
    }
    return t->n > 0 ? RL_OK
                    : rl_fail(error, RL_ERR_INPUT, "%d x %d pixels: none shows the object", width, height);
}

static int make_truth(struct truth *t, const char *parameters, int threads, struct rl_error *error)
{
    struct rl_interpolation_case c;
    struct rl_visible *visible = NULL;
    bool teapot = rl_parameters_match(parameters, "object=teapot");
    *t = (struct truth){0};
    int status =
        rl_interpolation_case_make(&c, parameters, teapot ? FINE_TEAPOT : FINE_SPHERE, threads, error);
    if (status != RL_OK)
        return status;
    status = rl_visible_make(&visible, &c.scene, NULL, true, error);
    if (status == RL_OK)
        status = find_points(t, &c, visible, error);
    rl_visible_free(visible);
    rl_interpolation_case_clear(&c);
    return status;
}

/* The mesh against the surface, point by point. */
static int add_error(struct rl_record *r, struct rl_interpolation_case *c, const struct truth *t,
                     const struct rl_mesh_point *at, struct rl_error *error)
{
    double squares = 0.0, most = 0.0;
    for (size_t i = 0; i < t->n; i++) {
        double e = rl_interpolation_mesh_radiance(c, &at[i]) - t->radiance[i];
        squares += e * e;
        most = fmax(most, fabs(e));
    }
    const struct {
        const char *name;
        double value;
    } row[] = {{"rmse", sqrt(squares / (double)t->n)},
               {"max", most},
               {"triangles", (double)c->scene.object[0].mesh.n_triangles},
               {"points", (double)t->n}};
    int status = RL_OK;
    for (size_t k = 0; k < sizeof row / sizeof row[0] && status == RL_OK; k++)
        status = rl_record_add(r, row[k].name, (struct rl_interval){row[k].value, row[k].value, row[k].value},
                               "1", error);
    return status;
}

/* All points, on one mesh. */
static int locate_all(struct rl_mesh_point **at, struct rl_interpolation_case *c, const struct truth *t,
                      struct rl_error *error)
{
    struct rl_mesh_locator *locator;
    *at = malloc(t->n * sizeof **at);
    if (!*at)
        return rl_fail_memory(error, "points of a mesh");
    int status = rl_mesh_locator_make(&locator, c->object, &c->scene.object[0].mesh, c->tessellation, error);
    for (size_t i = 0; i < t->n && status == RL_OK; i++)
        (*at)[i] = rl_mesh_locate(locator, &t->point[i]);
    rl_mesh_locator_free(locator);
    return status;
}

static int measure_error(struct rl_record *r, const struct truth *t, int threads, struct rl_error *error)
{
    struct rl_interpolation_case c;
    struct rl_mesh_point *at = NULL;
    int tessellation = (int)rl_parameter_number(r->parameters, "tessellation");
    int status = rl_interpolation_case_make(&c, r->parameters, tessellation, threads, error);
    if (status != RL_OK)
        return status;
    status = locate_all(&at, &c, t, error);
    if (status == RL_OK)
        status = add_error(r, &c, t, at, error);
    free(at);
    rl_interpolation_case_clear(&c);
    return status;
}

int rl_interpolation_measure_errors(struct rl_record *records, size_t n, struct rl_bench *bench,
                                    struct rl_error *error)
{
    struct truth truth;
    int threads = bench->threads > 0 ? bench->threads : rl_machine_threads();
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
    int status = make_truth(&truth, records[0].parameters, threads, error);
    rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    for (size_t i = 0; i < n && status == RL_OK; i++)
        status = measure_error(&records[i], &truth, threads, error);
    rl_spent_on(&bench->spent, outer);
    clear_truth(&truth);
    return status;
}
