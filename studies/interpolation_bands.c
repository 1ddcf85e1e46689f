/* Bands of the study `interpolation`: radiance along a line of the picture, and its changes of slope, at edges of triangles and from pixel to
 * pixel (see interpolation.h). */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "reference/visible.h"
#include "studies/interpolation.h"

/* The line is walked in so many steps, whatever the picture's pixels are: what is found at edges is the mesh's own. Slopes on both sides of
 * an edge are taken within SIDE of it, a 2000th of a step: 1.5 SIDE times the bend of the radiance there is what they are off by. */
enum { LINE_LEAST = 3, STEPS = 4096, HALVINGS = 40 };
static const double SIDE = 1e-7;

struct line {
    struct rl_interpolation_case *c;
    struct rl_visible *visible;
    bool exact;
};

/* Through the middle row of pixels, from the picture's left edge (t = 0) to its right one (1). */
static rl_vec3 direction_at(const struct rl_interpolation_case *c, double t)
{
    int width = c->plan.settings.width, height = c->plan.settings.height;
    rl_vec3 left = rl_camera_ray(&c->scene.camera, width, height, 0, height / 2);
    rl_vec3 right = rl_camera_ray(&c->scene.camera, width, height, width - 1, height / 2);
    const rl_vec3 forward = c->scene.camera.forward;
    left = v3_scale(1.0 / v3_dot(left, forward), left);
    right = v3_scale(1.0 / v3_dot(right, forward), right);
    double part = (t * width - 0.5) / (width - 1.0); /* both go through pixels' centres */
    return v3_normalize(v3_madd(v3_scale(1.0 - part, left), part, right));
}

/* Radiance there, NaN where the line shows nothing; and the triangle. */
static double look(const struct line *l, double t, size_t *triangle)
{
    struct rl_surface surface;
    struct rl_visible_hit hit;
    struct rl_exact_point p;
    *triangle = SIZE_MAX;
    if (!rl_visible_point(&surface, &hit, l->visible, direction_at(l->c, t)))
        return NAN;
    *triangle = hit.triangle;
    struct rl_mesh_point at = {hit.triangle, {hit.weight[0], hit.weight[1], hit.weight[2]}};
    if (!l->exact)
        return rl_interpolation_mesh_radiance(l->c, &at);
    rl_exact_from_mesh(&p, l->c->object, &l->c->scene.object[0].mesh, l->c->tessellation, &at);
    return rl_interpolation_radiance(l->c, p.P, p.N);
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

/* ---- At edges ---- */

/* Where between `in`, which shows the triangle, and `out` it ends. */
static double end_of(const struct line *l, size_t triangle, double in, double out)
{
    for (int i = 0; i < HALVINGS; i++) {
        double middle = 0.5 * (in + out);
        size_t there;
        (void)look(l, middle, &there);
        if (there == triangle)
            in = middle;
        else
            out = middle;
    }
    return in;
}

/* The triangle's slope at its end, where the line leaves it in that direction (1, -1); NaN of a triangle that is hardly there. */
static double slope_at(const struct line *l, size_t triangle, double end, double direction)
{
    size_t near, far;
    double a = look(l, end - direction * SIDE, &near), b = look(l, end - 2.0 * direction * SIDE, &far);
    return near == triangle && far == triangle ? (a - b) / (direction * SIDE) : NAN;
}

/* Largest slope on the line's middle stretch, and largest change of slope from one triangle to the next, edges found one by one. What
 * ends within a step is passed over: two edges there count as one. */
static int measure_slopes(const struct line *l, double *slope, double *jump, struct rl_error *error)
{
    double *value = calloc(STEPS, sizeof *value);
    size_t *triangle = calloc(STEPS, sizeof *triangle), first = 0, n = 0;
    *slope = *jump = 0.0;
    for (size_t i = 0; value && triangle && i < STEPS; i++)
        value[i] = look(l, ((double)i + 0.5) / STEPS, &triangle[i]);
    if (value && triangle)
        middle_stretch(&first, &n, value, STEPS);
    for (size_t i = first + 1; value && triangle && i < first + n; i++) {
        double t = ((double)i - 0.5) / STEPS, next = ((double)i + 0.5) / STEPS;
        if (triangle[i] == triangle[i - 1]) {
            *slope = fmax(*slope, fabs(value[i] - value[i - 1]) * STEPS);
            continue;
        }
        double before = slope_at(l, triangle[i - 1], end_of(l, triangle[i - 1], t, next), 1.0);
        double after = slope_at(l, triangle[i], end_of(l, triangle[i], next, t), -1.0);
        *jump = fmax(*jump, fabs(after - before));
    }
    int status = value && triangle ? RL_OK : rl_fail_memory(error, "a line");
    free(value);
    free(triangle);
    return status;
}

/* ---- At pixels ---- */

/* Radiance at the pixels, and its changes of slope from one to the next, the line's whole length being 1: a corner's stays as pixels shrink,
 * a smooth radiance's does not. Pictures for the eye: no verdict may rest on what depends on pixels. */
static int add_pixels(struct rl_record *r, const struct line *l, double *line, size_t width,
                      struct rl_error *error)
{
    double *bend = calloc(width, sizeof *bend), step = 0.0, most = 0.0;
    size_t first, n, triangle;
    if (!bend)
        return rl_fail_memory(error, "a line");
    for (size_t x = 0; x < width; x++)
        line[x] = look(l, ((double)x + 0.5) / (double)width, &triangle);
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
        status = rl_record_add_exact(r, "step", step, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "bend", most, "1", error);
    if (status == RL_OK)
        status = rl_record_series_add(r, "radiance", line, width, error);
    if (status == RL_OK)
        status = rl_record_series_add(r, "bend", bend, width, error);
    free(bend);
    return status;
}

static int add_bands(struct rl_record *r, const struct line *l, struct rl_error *error)
{
    size_t width = (size_t)l->c->plan.settings.width;
    double *line = calloc(width, sizeof *line), slope = 0.0, jump = 0.0;
    int status = line ? add_pixels(r, l, line, width, error) : rl_fail_memory(error, "a line");
    free(line);
    if (status == RL_OK)
        status = measure_slopes(l, &slope, &jump, error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "slope", slope, "1", error);
    return status == RL_OK ? rl_record_add_exact(r, "jump", jump, "1", error) : status;
}

int rl_interpolation_measure_bands(struct rl_record *r, struct rl_bench *bench, struct rl_error *error)
{
    struct rl_interpolation_case c;
    int tessellation = (int)rl_parameter_number(r->parameters, "tessellation");
    int status = rl_interpolation_case_make(&c, r->parameters, tessellation, 1, error);
    if (status != RL_OK)
        return status;
    struct line l = {.c = &c, .exact = rl_parameters_match(r->parameters, "surface=exact")};
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    status = rl_visible_make(&l.visible, &c.scene, NULL, true, error);
    if (status == RL_OK) {
        status = add_bands(r, &l, error);
        rl_visible_free(l.visible);
    }
    rl_spent_on(&bench->spent, outer);
    rl_interpolation_case_clear(&c);
    return status;
}
