/* A picture of the GPU against that of the CPU renderer, which computes in double precision. */
#ifndef RL_TESTS_GPU_AGAINST_CPU_H
#define RL_TESTS_GPU_AGAINST_CPU_H

#include "gpu/fixture.h"
#include "reference/renderer.h"

static inline void render_cpu(struct rl_image *image, const struct rl_scene *scene)
{
    struct rl_error error;
    struct rl_plan plan;
    struct rl_render_stats stats;
    check_ok(rl_plan_make(&plan, scene, &scene->settings, &error), &error);
    check_ok(rl_reference_render(image, &stats, scene, &plan, 1, NULL, &error), &error);
    rl_plan_clear(&plan);
}

/* At outlines the rasteriser decides to 1/256 of a pixel: another surface, or one a little off at a grazing angle. */
static inline void compare_images(const char *name, const struct rl_image *a, const struct rl_image *b,
                                  size_t outliers)
{
    size_t off = 0, foreground = 0;
    double worst = 0.0, sum = 0.0, brightest = 0.0;
    for (int y = 0; y < b->height; y++)
        for (int x = 0; x < b->width; x++) {
            const float *p = rl_image_pixel((struct rl_image *)a, x, y);
            const float *q = rl_image_pixel((struct rl_image *)b, x, y);
            double here = 0.0, value = 0.0;
            for (int c = 0; c < 4; c++) {
                assert_true(isfinite(p[c]) && isfinite(q[c]));
                here = fmax(here, fabs((double)p[c] - (double)q[c]));
                value = fmax(value, fabs((double)q[c]));
            }
            foreground += q[3] > 0.0f;
            brightest = fmax(brightest, value);
            if (here > 2e-4 * (1.0 + value)) {
                off++;
                continue;
            }
            worst = fmax(worst, here);
            sum += here * here;
        }
    print_message("%-16s values to %-6.3g worst %-8.2g rmse %-8.2g outliers %zu of %zu\n", name, brightest,
                  worst, sqrt(sum / (double)foreground), off, foreground);
    assert_true(10 * foreground > (size_t)b->width * (size_t)b->height);
    assert_in_range(off, 0, outliers);
    assert_true(sqrt(sum / (double)foreground) < 2e-5);
}

/* The scene drawn by both, in its own settings. */
static inline void check_against_cpu(const char *name, struct rl_gpu *gpu, const struct rl_scene *scene,
                                     size_t outliers)
{
    struct rl_image drawn, expected;
    fixture_render(&drawn, gpu, scene, &scene->settings);
    render_cpu(&expected, scene);
    compare_images(name, &drawn, &expected, outliers);
    rl_image_clear(&drawn);
    rl_image_clear(&expected);
}

#endif
