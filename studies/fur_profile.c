/* The middle column of a picture of the ball against the closed form (see fur.h). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/fur.h"

/* One pixel that shows the ball: where N is, seen from the eye and from the light (radians, up is positive), and both radiances. */
struct seen {
    double angle, from_light, radiance, closed;
};

/* The point of the exact ball on a ray from the camera; false: none. */
static bool meet(rl_vec3 *N, rl_vec3 eye, rl_vec3 direction)
{
    double b = v3_dot(eye, direction), under = b * b - v3_dot(eye, eye) + 1.0;
    if (under < 0.0)
        return false;
    *N = v3_normalize(v3_madd(eye, -b - sqrt(under), direction));
    return true;
}

static double elevation(rl_vec3 v)
{
    return atan2(v.y, v.z);
}

static size_t look(struct seen *seen, const struct rl_image *image, const struct rl_camera *camera,
                   const char *parameters)
{
    size_t n = 0;
    char effect[RL_NAME_MAX];
    rl_parameter(parameters, "effect", effect, sizeof effect);
    double beta = elevation(rl_fur_light(rl_parameter_number(parameters, "beta")));
    double exponent = rl_parameter_number(parameters, "exponent");
    for (int y = image->height - 1; y >= 0; y--) {
        rl_vec3 N;
        const float *pixel = rl_image_pixel(image, image->width / 2, y);
        rl_vec3 ray = rl_camera_ray(camera, image->width, image->height, image->width / 2, y);
        if (!(pixel[3] > 0.0f) || !meet(&N, camera->position, ray))
            continue;
        double at = elevation(N), to_eye = elevation(v3_sub(camera->position, N));
        seen[n++] = (struct seen){at - to_eye, at - beta, pixel[0],
                                  rl_fur_closed(effect, exponent, at, to_eye, beta)};
    }
    return n;
}

/* Where N = e: brought there along a straight line from either side, since the radiance has a corner there, or a step. */
static double middle_of(const struct seen *seen, size_t n)
{
    size_t after = 0;
    while (after < n && seen[after].angle < 0.0)
        after++;
    if (after < 2 || after + 1 >= n)
        return NAN;
    double below = 1.5 * seen[after - 1].radiance - 0.5 * seen[after - 2].radiance;
    double above = 1.5 * seen[after].radiance - 0.5 * seen[after + 1].radiance;
    return 0.5 * (below + above);
}

static int add_line(struct rl_record *r, const struct seen *seen, size_t n, struct rl_error *error)
{
    double *pairs = malloc(2 * n * sizeof *pairs);
    if (!pairs)
        return rl_fail_memory(error, "a profile");
    for (size_t i = 0; i < n; i++) {
        pairs[2 * i] = seen[i].angle * 180.0 / RL_PI;
        pairs[2 * i + 1] = seen[i].radiance;
    }
    int status = rl_record_series_add(r, "profile", pairs, 2 * n, error);
    free(pairs);
    return status;
}

static int add(struct rl_record *r, const char *name, double value, double off, struct rl_error *error)
{
    return rl_record_metric_add(r, name, value, value - off, value + off, "1", error);
}

/* Goldman's kappa has a step where N is parallel to e or l, and this near to it a mesh may be on either side. */
static bool at_step(const struct seen *s)
{
    static const double degree = RL_PI / 180.0;
    return fabs(sin(s->angle)) < degree || fabs(sin(s->from_light)) < degree;
}

static int add_figures(struct rl_record *r, const struct seen *seen, size_t n, struct rl_error *error)
{
    double off = 0.0, least = INFINITY;
    bool steps = strstr(r->parameters, "effect=goldman") != NULL;
    if (n < 4 || isnan(middle_of(seen, n)))
        return rl_fail(
            error, RL_ERR_INPUT,
            "the picture's middle column shows %zu pixels of the ball, expected two on each side of "
            "its middle",
            n);
    for (size_t i = 0; i < n; i++) {
        if (!steps || !at_step(&seen[i]))
            off = fmax(off, fabs(seen[i].radiance - seen[i].closed));
        least = fmin(least, seen[i].radiance);
    }
    int status = add(r, "middle", middle_of(seen, n), off, error);
    if (status == RL_OK)
        status = add(r, "rim", fmax(seen[0].radiance, seen[n - 1].radiance), off, error);
    if (status == RL_OK)
        status = add(r, "least", least, 0.0, error);
    if (status == RL_OK)
        status = add(r, "off", off, 0.0, error);
    return status == RL_OK && rl_parameters_match(r->parameters, "line=on") ? add_line(r, seen, n, error)
                                                                            : status;
}

int rl_fur_measure_profile(struct rl_record *r, struct rl_bench *bench, struct rl_error *error)
{
    struct rl_fur_scene s;
    struct rl_image image = {0};
    struct seen *seen = NULL;
    int status = rl_fur_scene_make(&s, NULL, r->parameters, error);
    if (status == RL_OK)
        status = rl_bench_picture(&image, bench, &s.scene, r->parameters, 1, error);
    if (status == RL_OK && !(seen = malloc((size_t)image.height * sizeof *seen)))
        status = rl_fail_memory(error, "a profile");
    if (status == RL_OK)
        status = add_figures(r, seen, look(seen, &image, &s.scene.camera, r->parameters), error);
    free(seen);
    rl_image_clear(&image);
    rl_fur_scene_clear(&s);
    return status;
}
