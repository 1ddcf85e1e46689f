/* Budgets: passes, what a pixel keeps, and that the errors an unfinished image states hold. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reference/accuracy.h"
#include "reference/renderer.h"
#include "support/check.h"

enum { WIDTH = 64, HEIGHT = 48, VALUES = 4 * WIDTH * HEIGHT };

static void test_passes(void **state)
{
    (void)state;
    static const struct {
        double wanted;
        int n;
        double first;
    } row[] = {{0.1, 1, 0.1},   {1e-2, 1, 1e-2}, {4e-3, 1, 4e-3},  {1e-3, 2, 1e-2},
               {1e-5, 3, 1e-2}, {1e-6, 3, 1e-2}, {1e-10, 5, 1e-2}, {1e-12, 6, 1e-2}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        double tolerance[RL_PASSES_MAX];
        int n = rl_accuracy_passes(tolerance, row[i].wanted);
        assert_int_equal(n, row[i].n);
        assert_true(tolerance[0] == row[i].first && tolerance[n - 1] == row[i].wanted);
        for (int j = 1; j < n; j++)
            assert_true(tolerance[j] < tolerance[j - 1]);
    }
}

static void test_improve(void **state)
{
    (void)state;
    struct rl_accuracy reached = {0};
    const struct rl_estimate loose = {.error = {1e-3, 0.0, 1e-4}, .converged = true};
    const struct rl_estimate worse = {.error = {0.0, 2e-3, 0.0}, .converged = true};
    const struct rl_estimate tight = {.error = {0.9e-6, 0.0, 0.0}, .converged = true};
    const struct rl_estimate nearly = {.error = {0.985e-6, 0.0, 0.0}, .converged = true};
    assert_true(rl_accuracy_improve(&reached, &loose, 1e-6, false));
    assert_true(reached.drawn && !reached.done && reached.error[0] >= 1e-3);
    assert_false(rl_accuracy_improve(&reached, &worse, 1e-6, false));
    assert_true(reached.error[1] == 0.0f);
    /* So near to the tolerance the last pass might take one more step: only that one may call it done. */
    assert_true(rl_accuracy_improve(&reached, &nearly, 1e-6, false));
    assert_false(reached.done);
    assert_true(rl_accuracy_improve(&reached, &nearly, 1e-6, true));
    assert_true(reached.done);
    reached = (struct rl_accuracy){0};
    assert_true(rl_accuracy_improve(&reached, &tight, 1e-6, false));
    assert_true(reached.done);
}

static void test_summary(void **state)
{
    (void)state;
    float data[4 * 4] = {1, 1, 1, 1, 0, 0, 0, 0, 1, NAN, 1, 1, 0, 0, 0, 0};
    const struct rl_image image = {.width = 2, .height = 2, .channels = 4, .data = data};
    const struct rl_accuracy reached[4] = {{{1.0f, 2.0f, 3.0f}, true, true},
                                           {{9.0f, 9.0f, 9.0f}, false, true},
                                           {{4.0f, 0.0f, 0.0f}, true, false},
                                           {{0}, false, true}};
    struct rl_accuracy_summary s;
    rl_accuracy_summarise(&s, reached, &image);
    assert_int_equal(s.foreground, 2);
    assert_int_equal(s.within, 1);
    assert_int_equal(s.nonfinite, 1);
    check_near(s.worst_error, 4.0, 0.0);
    check_near(s.mean_error, 10.0 / 6.0, 1e-15);
    check_near(s.rms_error, sqrt(30.0 / 6.0), 1e-15);
}

struct picture {
    struct rl_image image, errors;
    struct rl_render_stats stats;
};

static void draw(struct picture *p, const struct rl_scene *scene, double tolerance, double max_seconds)
{
    struct rl_error error;
    struct rl_plan plan;
    struct rl_settings settings = scene->settings;
    settings.method = "reference";
    settings.width = WIDTH;
    settings.height = HEIGHT;
    settings.tolerance = tolerance;
    memset(p, 0, sizeof *p);
    const struct rl_render_limits limits = {.max_seconds = max_seconds, .errors = &p->errors};
    check_ok(rl_plan_make(&plan, scene, &settings, &error), &error);
    check_ok(rl_reference_render_within(&p->image, &p->stats, scene, &plan, &limits, NULL, &error), &error);
    rl_plan_clear(&plan);
}

static void picture_clear(struct picture *p)
{
    rl_image_clear(&p->image);
    rl_image_clear(&p->errors);
}

/* No time at all: one pass, its errors stated and true. More of it never makes a pixel worse, and enough of it gives the image
 * of no budget, to within the errors: a pixel that was within the tolerance after a looser pass is left. */
static void test_budgets(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_error error;
    check_ok(rl_scene_load(&scene, "studies/scenes/sphere-quad.yaml", &error), &error);
    struct picture full, none, some, ample;
    draw(&full, &scene, 1e-7, 0.0);
    assert_int_equal(full.stats.passes, 1);
    assert_int_equal(full.stats.unconverged, 0);

    draw(&none, &scene, 1e-7, 1e-9);
    assert_int_equal(none.stats.passes_completed, 1);
    assert_true(none.stats.first_seconds > 1e-9 && none.stats.passes > 2);
    assert_true(none.stats.unconverged > 0 && none.stats.unconverged < none.stats.foreground);
    assert_true(none.stats.worst_error > 1e-4 && none.stats.worst_error <= 1e-2);
    assert_true(none.stats.mean_error > 0.0 && none.stats.mean_error < none.stats.rms_error &&
                none.stats.rms_error < none.stats.worst_error);
    double largest = 0.0;
    for (size_t i = 0; i < VALUES; i++) {
        double difference = fabs((double)none.image.data[i] - full.image.data[i]);
        double bound = i % 4 == 3 ? 0.0 : (double)none.errors.data[i] + full.errors.data[i];
        assert_true(difference <= bound);
        largest = fmax(largest, difference);
    }
    print_message("largest difference %g, largest stated error %g\n", largest, none.stats.worst_error);
    assert_true(largest > 0.0);

    /* Somewhere within the second or third pass. */
    draw(&some, &scene, 1e-7, 1.1 * none.stats.seconds);
    draw(&ample, &scene, 1e-7, 1000.0);
    for (size_t i = 0; i < VALUES; i++) {
        if (i % 4 != 3)
            assert_true(some.errors.data[i] <= 1.000001f * none.errors.data[i]);
        assert_true(fabs((double)ample.image.data[i] - full.image.data[i]) <=
                    (i % 4 == 3 ? 0.0 : (double)ample.errors.data[i] + full.errors.data[i]));
    }
    assert_int_equal(ample.stats.passes_completed, ample.stats.passes);
    assert_int_equal(ample.stats.unconverged, 0);
    assert_true(ample.stats.worst_error <= 1e-7 * 2.0 && full.stats.worst_error <= 1e-7 * 2.0);
    picture_clear(&full);
    picture_clear(&none);
    picture_clear(&some);
    picture_clear(&ample);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_passes),
        cmocka_unit_test(test_improve),
        cmocka_unit_test(test_summary),
        cmocka_unit_test(test_budgets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
