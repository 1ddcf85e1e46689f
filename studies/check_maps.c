/* The check's cases of normal maps: moments of the texels as the GPU has them. Nothing here asks the model what they should be, else a fault
 * of the model would be on both sides. */
#include <math.h>
#include <stdlib.h>

#include "base/progress.h"
#include "gpu/gpu.h"
#include "methods/method.h"
#include "studies/check_parts.h"

/* Means over the texels of one map; s = |sin delta|, theta the azimuth of H. */
enum moment {
    WIDTH,  /* of R s/(1 + R s): for a change of R by 1 % it moves by 0.0013 to 0.002 */
    SPREAD, /* of s^2: the tails */
    TILT_Y, /* of H_y and H_z: an unsigned normalised map tilts them */
    TILT_Z,
    TURN_COS, /* of cos 2 theta and sin 2 theta: 0 if theta is uniform */
    TURN_SIN,
    ALIKE,        /* of the sign of H_y times that of neighbours along x and y: 0 if texels are independent */
    ALIKE_ANGLES, /* of the sign of cos theta times that of the next texel's delta: they too are independent */
    ROUNDING,     /* root mean square distance of the components from the normals before they were stored */
    MOMENTS
};

static const struct {
    const char *name;
    enum rl_best best;
    double relevant, relative; /* a change that matters, as it is, and in proportion to the value */
} moments[MOMENTS] = {
    [WIDTH] = {"width", RL_BEST_SAME, 0.002, 0.0},
    [SPREAD] = {"spread", RL_BEST_SAME, 0.0, 0.1},
    [TILT_Y] = {"tilt_y", RL_BEST_ZERO, 0.003, 0.0},
    [TILT_Z] = {"tilt_z", RL_BEST_ZERO, 0.003, 0.0},
    [TURN_COS] = {"turn_cos", RL_BEST_ZERO, 0.01, 0.0},
    [TURN_SIN] = {"turn_sin", RL_BEST_ZERO, 0.01, 0.0},
    [ALIKE] = {"alike", RL_BEST_ZERO, 0.01, 0.0},
    [ALIKE_ANGLES] = {"alike_angles", RL_BEST_ZERO, 0.01, 0.0},
    [ROUNDING] = {"rounding", RL_BEST_LOWER, 0.0, 0.02},
};

static rl_vec3 decode(const float texel[4])
{
    return v3(2.0 * texel[0] - 1.0, 2.0 * texel[1] - 1.0, 2.0 * texel[2] - 1.0);
}

static double sign_of(const float texel[4], int component)
{
    return texel[component] > 0.5f ? 1.0 : -1.0;
}

static void add_texel(double sum[MOMENTS], const float *texels, size_t index, size_t size, double rr)
{
    const float *texel = texels + 4 * index;
    rl_vec3 h = decode(texel);
    double ss = h.y * h.y + h.z * h.z, x = rr * sqrt(ss / v3_dot(h, h));
    sum[WIDTH] += x / (1.0 + x);
    sum[SPREAD] += ss;
    sum[TILT_Y] += h.y;
    sum[TILT_Z] += h.z;
    if (ss > 0.0) {
        sum[TURN_COS] += (h.y * h.y - h.z * h.z) / ss;
        sum[TURN_SIN] += 2.0 * h.y * h.z / ss;
    }
    size_t right = index + 1 < size * size ? index + 1 : 0, above = (index + size) % (size * size);
    sum[ALIKE_ANGLES] += sign_of(texel, 1) * sign_of(texel, 2) * sign_of(texels + 4 * right, 2);
    sum[ALIKE] += 0.5 * sign_of(texel, 1) * (sign_of(texels + 4 * right, 1) + sign_of(texels + 4 * above, 1));
}

/* Of the first texels: they are drawn once more, which takes longer than all the rest. */
static double rounding(const float *texels, size_t n, const struct rl_plan_normal_map *map, uint64_t seed)
{
    const struct rl_ellipsoid e = rl_ellipsoid_make(map->rr);
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) {
        struct rl_microfacet exact = map->method->texel(&e, seed, i);
        rl_vec3 moved = v3_sub(decode(texels + 4 * i), v3(exact.x, exact.y, exact.z));
        sum += v3_dot(moved, moved);
    }
    return sqrt(sum / (3.0 * (double)n));
}

static int measure_seed(double value[MOMENTS], const struct rl_plan_normal_map *map,
                        const struct rl_settings *settings, struct rl_bench *bench, struct rl_error *error)
{
    enum { ROUNDED = 1 << 13 };
    float *texels = NULL;
    size_t size = (size_t)settings->normal_size, n = size * size;
    int status = rl_gpu_normal_map_read(&texels, bench->gpu, map, settings, error);
    if (status != RL_OK)
        return status;
    double sum[MOMENTS] = {0.0};
    for (size_t i = 0; i < n; i++)
        add_texel(sum, texels, i, size, map->rr);
    for (int m = 0; m < MOMENTS; m++)
        value[m] = sum[m] / (double)n;
    value[ROUNDING] = rounding(texels, n < ROUNDED ? n : ROUNDED, map, settings->seed);
    free(texels);
    return RL_OK;
}

int rl_check_map(struct rl_check_rows *rows, const struct rl_check_case *c, struct rl_check_context *context)
{
    double value[MOMENTS][RL_CHECK_SEEDS_MAX];
    struct rl_settings settings;
    int status = rl_bench_settings(&settings, c->parameters, rows->error);
    const struct rl_plan_normal_map map = {.rr = settings.rr, .method = rl_method_find("random")};
    size_t n = context->options->seeds;
    for (size_t k = 0; k < n && status == RL_OK; k++) {
        double moment[MOMENTS] = {0.0};
        if (rl_progress_cancelled(&context->bench->quiet))
            return rl_fail(rows->error, RL_ERR_CANCELLED, "interrupted");
        settings.seed = context->first_seed + k;
        status = measure_seed(moment, &map, &settings, context->bench, rows->error);
        for (int m = 0; m < MOMENTS; m++)
            value[m][k] = moment[m];
    }
    for (int m = 0; m < MOMENTS && status == RL_OK; m++) {
        double relevant = moments[m].relevant + moments[m].relative * fabs(rl_mean_of(value[m], n).value);
        rl_check_random(rows, moments[m].name, moments[m].best, value[m], n, relevant);
    }
    return status;
}
