/* What the tests of image files share: a folder of their own with two names in it, and images to put there.
 * Include after cmocka.h. */
#ifndef RL_TESTS_IMAGE_FIXTURE_H
#define RL_TESTS_IMAGE_FIXTURE_H

#include "image/image.h"
#include "support/check.h"
#include "support/temporary.h"

static struct rl_error error;
static struct temporary folder;
static char exr[PATH_MAX], png[PATH_MAX];

static inline int set_up(void **state)
{
    (void)state;
    temporary_make(&folder);
    temporary_path(&folder, exr, "a.exr");
    temporary_path(&folder, png, "a.png");
    return 0;
}

static inline int tear_down(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

static inline void make(struct rl_image *image, int width, int height, int channels)
{
    check_ok(rl_image_allocate(image, width, height, channels, &error), &error);
    for (int i = 0; i < width * height * channels; i++)
        image->data[i] = (float)(i % 97) / 97.0F;
}

/* Bit for bit, channels matched by name. */
static inline void assert_same_pixels(const struct rl_image *a, const struct rl_image *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_int_equal(a->channels, b->channels);
    for (int c = 0; c < a->channels; c++) {
        int other = rl_image_channel(b, a->channel_name[c]);
        assert_true(other >= 0);
        for (int y = 0; y < a->height; y++)
            for (int x = 0; x < a->width; x++)
                assert_memory_equal(rl_image_pixel(a, x, y) + c, rl_image_pixel(b, x, y) + other,
                                    sizeof(float));
    }
}

#endif
