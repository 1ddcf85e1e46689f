/* Figures of one picture alone: it has no seeds to tell how sure they are, but what it is held against is known to a tolerance. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/seeds.h"
#include "support/check.h"

static struct rl_error error;

static bool near(double a, double b)
{
    return fabs(a - b) < 1e-7;
}

static void fill(struct rl_image *image, const float value[2])
{
    check_ok(rl_image_allocate(image, 2, 1, 1, &error), &error);
    memcpy(image->data, value, 2 * sizeof *value);
}

static void as_sure_as_the_reference(void **state)
{
    (void)state;
    static const struct {
        const char *metric;
        double value, room;
    } rows[] = {
        {"rmse", 0.5, 0.01},          {"mae", 0.5, 0.01},          {"bias", 0.5, 0.01},
        {"floor", 0.5, 0.01},         {"rmse_centre", 0.25, 0.01}, {"floor_centre", 0.25, 0.01},
        {"parallax", 0.25, 2 * 0.01}, {"noise", 0.0, 0.0}, /* of pictures alone */
    };
    struct rl_seeds s = {.n = 1};
    struct rl_image truth = {0}, centre = {0};
    struct rl_run run = {.study = "made-up"};
    struct rl_place place = {"made-up", "one", "one.yaml", 1};
    struct rl_record *r = rl_run_add(&run, &place, 0, &error, "tolerance=0.01");
    fill(&s.image[0], (const float[]){1.0F, 2.0F});
    fill(&truth, (const float[]){0.5F, 1.5F});
    fill(&centre, (const float[]){0.75F, 1.75F});
    check_ok(rl_seeds_add_error(r, &s, &truth, &centre, &error), &error);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct rl_metric *m = rl_record_metric(r, rows[i].metric);
        assert_non_null(m);
        if (!near(m->value, rows[i].value) || !near(m->low, rows[i].value - rows[i].room) ||
            !near(m->high, rows[i].value + rows[i].room))
            fail_msg("%s is %g [%g, %g], expected %g to within %g", rows[i].metric, m->value, m->low, m->high,
                     rows[i].value, rows[i].room);
    }
    rl_image_clear(&truth);
    rl_image_clear(&centre);
    rl_seeds_clear(&s);
    rl_run_clear(&run);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(as_sure_as_the_reference)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
