/* Bands of the study `interpolation`: radiance along a line of the picture, and its changes of slope (see interpolation.h). */
#include <math.h>
#include <stdlib.h>

#include "reference/visible.h"
#include "studies/interpolation.h"

enum { LINE_LEAST = 3 };

/* Radiance along the middle line of the picture, NaN where it shows nothing. */
static int draw_line(double *line, struct rl_interpolation_case *c, bool exact, struct rl_error *error)
{
    struct rl_visible *visible;
    int width = c->plan.settings.width, height = c->plan.settings.height;
    int status = rl_visible_make(&visible, &c->scene, true, error);
    for (int x = 0; x < width && status == RL_OK; x++) {
        struct rl_surface surface;
        struct rl_visible_hit hit;
        rl_vec3 direction = rl_camera_ray(&c->scene.camera, width, height, x, height / 2);
        line[x] = NAN;
        if (!rl_visible_point(&surface, &hit, visible, direction))
            continue;
        struct rl_mesh_point at = {hit.triangle, {hit.weight[0], hit.weight[1], hit.weight[2]}};
        struct rl_exact_point p;
        rl_exact_from_mesh(&p, c->object, &c->scene.object[0].mesh, c->tessellation, &at);
        line[x] = exact ? rl_interpolation_radiance(c, p.P, p.N) : rl_interpolation_mesh_radiance(c, &at);
    }
    rl_visible_free(visible);
    return status;
}

/* The middle half of the longest stretch of the line that shows the object without a gap: towards outlines the slope of even a smooth
 * surface's radiance has no bound. */
static void middle_stretch(size_t *first, size_t *n, const double *line, size_t width)
{
    *first = *n = 0;
    for (size_t i = 0; i < width; i++) {
        size_t end = i;
        while (end < width && !isnan(line[end]))
            end++;
        if (end - i > *n) {
            *first = i;
            *n = end - i;
        }
        i = end;
    }
    *first += *n / 4;
    *n /= 2;
}

/* Changes of slope, the line's whole length being 1: of a smooth radiance they shrink with the pixels, a corner's stays. */
static int add_bands(struct rl_record *r, double *line, size_t width, struct rl_error *error)
{
    double *bend = calloc(width, sizeof *bend), step = 0.0, most = 0.0;
    size_t first, n;
    if (!bend)
        return rl_fail_memory(error, "a line");
    middle_stretch(&first, &n, line, width);
    for (size_t i = first + 1; i < first + n; i++)
        step = fmax(step, fabs(line[i] - line[i - 1]));
    for (size_t i = first + 1; i + 1 < first + n; i++) {
        bend[i] = (line[i + 1] - 2.0 * line[i] + line[i - 1]) * (double)width;
        most = fmax(most, fabs(bend[i]));
    }
    for (size_t i = 0; i < width; i++)
        if (isnan(line[i]))
            line[i] = 0.0;
    int status =
        n > LINE_LEAST ? RL_OK : rl_fail(error, RL_ERR_INPUT, "the line in the middle shows nothing");
    if (status == RL_OK)
        status = rl_record_add(r, "step", (struct rl_interval){step, step, step}, "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "bend", (struct rl_interval){most, most, most}, "1", error);
    if (status == RL_OK)
        status = rl_record_series_add(r, "radiance", line, width, error);
    if (status == RL_OK)
        status = rl_record_series_add(r, "bend", bend, width, error);
    free(bend);
    return status;
}

int rl_interpolation_measure_bands(struct rl_record *r, struct rl_bench *bench, struct rl_error *error)
{
    struct rl_interpolation_case c;
    bool exact = rl_parameters_match(r->parameters, "surface=exact");
    int tessellation = (int)rl_parameter_number(r->parameters, "tessellation");
    int status = rl_interpolation_case_make(&c, r->parameters, tessellation, 1, error);
    if (status != RL_OK)
        return status;
    size_t width = (size_t)c.plan.settings.width;
    double *line = calloc(width, sizeof *line);
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    status = line ? draw_line(line, &c, exact, error) : rl_fail_memory(error, "a line");
    if (status == RL_OK)
        status = add_bands(r, line, width, error);
    rl_spent_on(&bench->spent, outer);
    free(line);
    rl_interpolation_case_clear(&c);
    return status;
}
