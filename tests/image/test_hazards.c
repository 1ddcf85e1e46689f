/* Values that a picture of light should not have, from files: read as they are, counted, never changed. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/files.h"
#include "image/fixture.h"
#include "image/oiio.h"

static int save(void *user, const void *bytes, size_t size, struct rl_error *e)
{
    return rl_file_write(user, bytes, size, e);
}

/* Past rl_image_write, which would refuse it. */
static void write_anything(const struct rl_image *image)
{
    const struct rl_oiio *oiio = NULL;
    check_ok(rl_oiio_load(&oiio, &error), &error);
    check_ok(oiio->encode("exr", image, image->data, save, exr, &error), &error);
}

/* One value of a picture of 2 x 1, the others 0.5. */
static void test_census(void **state)
{
    (void)state;
    static const struct {
        float value;
        size_t nonfinite, negative, large;
        double least, most;
    } row[] = {
        {0.25F, 0, 0, 0, 0.25, 0.5},
        {0.0F, 0, 0, 0, 0.0, 0.5},
        {-0.0F, 0, 0, 0, 0.0, 0.5},
        {-FLT_TRUE_MIN, 0, 1, 0, -FLT_TRUE_MIN, 0.5},
        {-0.004F, 0, 1, 0, -0.004F, 0.5},
        {65504.0F, 0, 0, 0, 0.5, 65504.0},
        {65504.0039F, 0, 0, 1, 0.5, 65504.00390625},
        {1e30F, 0, 0, 1, 0.5, 1e30F},
        {FLT_MAX, 0, 0, 1, 0.5, FLT_MAX},
        {-FLT_MAX, 0, 1, 0, -FLT_MAX, 0.5},
        {INFINITY, 1, 0, 0, 0.5, 0.5},
        {-INFINITY, 1, 0, 0, 0.5, 0.5},
        {NAN, 1, 0, 0, 0.5, 0.5},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_image image = {0}, back = {0};
        struct rl_image_census c;
        check_ok(rl_image_allocate(&image, 2, 1, 4, &error), &error);
        for (int k = 0; k < 8; k++)
            image.data[k] = 0.5F;
        image.data[5] = row[i].value;
        write_anything(&image);
        check_ok(rl_image_read(&back, exr, &error), &error);
        assert_same_pixels(&image, &back);
        rl_image_census(&c, &back);
        if (c.values != 8 || c.nonfinite != row[i].nonfinite || c.negative != row[i].negative ||
            c.large != row[i].large || c.least != row[i].least || c.most != row[i].most)
            fail_msg("%g: %zu nonfinite, %zu negative, %zu large, %g to %g", row[i].value, c.nonfinite,
                     c.negative, c.large, c.least, c.most);
        /* Neither format takes what is not finite. */
        int status = rl_image_write(&back, i % 2 ? exr : png, NULL, &error);
        assert_int_equal(status, row[i].nonfinite ? RL_ERR_CHECK : RL_OK);
        rl_image_clear(&image);
        rl_image_clear(&back);
    }
}

/* Nothing finite at all. */
static void test_nothing_finite(void **state)
{
    (void)state;
    struct rl_image image = {0};
    struct rl_image_census c;
    check_ok(rl_image_allocate(&image, 1, 1, 3, &error), &error);
    image.data[0] = NAN;
    image.data[1] = INFINITY;
    image.data[2] = -INFINITY;
    rl_image_census(&c, &image);
    assert_true(c.nonfinite == 3 && c.negative == 0 && c.large == 0 && isnan(c.least) && isnan(c.most));
    rl_image_clear(&image);
}

/* Colours of 8 bits, by their alpha: what is clipped, how, and the byte that is left. */
static void test_clipping(void **state)
{
    (void)state;
    static const struct {
        float colour, alpha;
        size_t above, below, uncovered;
        double left;
    } row[] = {
        {0.0F, 1.0F, 0, 0, 0, 0.0},
        {1.0F, 1.0F, 0, 0, 0, 1.0},
        {0x1.000002p0F, 1.0F, 1, 0, 0, 1.0}, /* one unit in the last place above */
        {0x1.fffffep-1F, 1.0F, 0, 0, 0, 1.0},
        {-FLT_TRUE_MIN, 1.0F, 0, 1, 0, 0.0},
        {-0.0F, 1.0F, 0, 0, 0, 0.0},
        {1e30F, 1.0F, 1, 0, 0, 1.0},
        {-1e30F, 1.0F, 0, 1, 0, 0.0},
        {0.5F, 0.5F, 0, 0, 0, 0.50196078431372548},           /* 1 at a coverage of 128/255 */
        {0.5F, 0x1.fffffep-2F, 1, 0, 0, 0.49803921568627451}, /* at one of 127/255 */
        {1e-30F, 0.0F, 0, 0, 1, 0.0},
        {0.0F, 0.0F, 0, 0, 0, 0.0},
        {FLT_TRUE_MIN, FLT_TRUE_MIN, 0, 0, 0, 0.0}, /* 1 at a coverage that rounds to 0 */
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_image image = {0}, back = {0};
        struct rl_write_report r;
        check_ok(rl_image_allocate(&image, 1, 1, 4, &error), &error);
        image.data[0] = row[i].colour;
        image.data[3] = row[i].alpha;
        check_ok(rl_image_write(&image, png, &r, &error), &error);
        if (r.above != row[i].above || r.below != row[i].below || r.uncovered != row[i].uncovered ||
            r.clipped != r.above + r.below + r.uncovered || r.nonfinite != 0)
            fail_msg("row %zu: %zu above, %zu below, %zu uncovered, %zu in all", i, r.above, r.below,
                     r.uncovered, r.clipped);
        check_ok(rl_image_read(&back, png, &error), &error);
        check_near(back.data[0], row[i].left, 1e-7);
        rl_image_clear(&image);
        rl_image_clear(&back);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_census, set_up, tear_down),
        cmocka_unit_test(test_nothing_finite),
        cmocka_unit_test_setup_teardown(test_clipping, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
