/* Radiance at vertices and of triangles (see interpolated.h). */
#include "reference/interpolated.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

/* Where a vertex or a triangle is shaded. */
struct place {
    rl_vec3 P, N;
};

static struct place place_of_vertex(const struct rl_mesh *mesh, size_t i)
{
    const float *p = mesh->position[i], *n = mesh->normal[i];
    return (struct place){v3(p[0], p[1], p[2]), v3_normalize(v3(n[0], n[1], n[2]))};
}

static struct place place_of_triangle(const struct rl_mesh *mesh, size_t i)
{
    struct place place;
    rl_mesh_facet(mesh, i, &place.P, &place.N);
    return place;
}

/* Of a vertex: in single precision as a shader has it, differences of more over a pixel's width would not be numbers. */
static const double shading_most = 1e30;

static void shade(double rgb[3], double error[3], const struct rl_interpolated_shading *shading,
                  const struct place *at, double side)
{
    struct rl_lights lights = *shading->lights;
    if (shading->shadows)
        lights.visibility =
            rl_shadows_see(&shading->view[omp_get_thread_num()], shading->shadows, shading->object);
    const struct rl_surface s = {at->P, v3_scale(side, at->N), v3_normalize(v3_sub(shading->eye, at->P))};
    double off[3];
    rl_effects_shade_within(shading->effect, shading->n_effects, shading->params, &s, &lights, rgb, off);
    for (int c = 0; c < 3; c++) {
        rgb[c] = rgb[c] > shading_most ? shading_most : rgb[c]; /* NaN stays */
        error[c] = fmax(error[c], off[c]);
    }
}

int rl_interpolated_make(struct rl_interpolated *interpolated, const struct rl_mesh *mesh,
                         enum rl_interpolation interpolation, const struct rl_interpolated_shading *shading,
                         int threads, struct rl_error *error)
{
    *interpolated = (struct rl_interpolated){.mesh = mesh, .interpolation = interpolation};
    if (interpolation == RL_INTERPOLATION_PHONG)
        return RL_OK;
    const bool constant = interpolation == RL_INTERPOLATION_CONSTANT;
    const size_t n = constant ? mesh->n_triangles : mesh->n_vertices;
    double(*radiance)[3] = calloc(n + 1, sizeof *radiance);
    double(*behind)[3] = shading->both_sides ? calloc(n + 1, sizeof *behind) : NULL;
    interpolated->radiance = radiance;
    interpolated->behind = behind;
    if (!radiance || (shading->both_sides && !behind)) {
        rl_interpolated_clear(interpolated);
        return rl_fail_memory(error, "the shading of vertices");
    }
    double error_rgb[3] = {0.0, 0.0, 0.0};
#pragma omp parallel for num_threads(threads) reduction(max : error_rgb)
    for (size_t i = 0; i < n; i++) {
        const struct place at = (constant ? place_of_triangle : place_of_vertex)(mesh, i);
        shade(radiance[i], error_rgb, shading, &at, 1.0);
        if (behind)
            shade(behind[i], error_rgb, shading, &at, -1.0);
    }
    memcpy(interpolated->error, error_rgb, sizeof error_rgb);
    return RL_OK;
}

void rl_interpolated_clear(struct rl_interpolated *interpolated)
{
    free(interpolated->radiance);
    free(interpolated->behind);
    *interpolated = (struct rl_interpolated){0};
}

void rl_interpolated_at(double rgb[3], const struct rl_interpolated *interpolated, size_t triangle,
                        const double weight[3], bool from_behind)
{
    const double(*radiance)[3] =
        (const double(*)[3])(from_behind ? interpolated->behind : interpolated->radiance);
    if (interpolated->interpolation == RL_INTERPOLATION_CONSTANT) {
        memcpy(rgb, radiance[triangle], sizeof radiance[triangle]);
        return;
    }
    const uint32_t *corner = interpolated->mesh->triangle[triangle];
    for (int c = 0; c < 3; c++)
        rgb[c] = weight[0] * radiance[corner[0]][c] + weight[1] * radiance[corner[1]][c] +
                 weight[2] * radiance[corner[2]][c];
}
