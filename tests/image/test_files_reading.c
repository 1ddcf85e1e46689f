/* Reading: other programs' files, and files that are damaged, absurd or no images at all. */
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/files.h"
#include "image/fixture.h"
#include "image/png_writer.h"

/* Not rl_file_write, which waits for the disk: these are many. */
static void put(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static void read_png(struct rl_image *image, const struct png_writer *writer)
{
    put(png, writer->bytes, writer->size);
    check_ok(rl_image_read(image, png, &error), &error);
}

static void test_integers_are_decoded_from_srgb(void **state)
{
    (void)state;
    /* 16 bits: 0, 0x8000 (0.214048 in linear light), 0xffff; and alpha 1/2 as it is */
    const unsigned char row[] = {0, 0x00, 0x00, 0x80, 0x00, 0xff, 0xff, 0x80, 0x00};
    struct png_writer writer;
    struct rl_image image = {0};
    png_begin(&writer, 1, 1, 16, 6);
    png_end(&writer, row, sizeof row);
    read_png(&image, &writer);
    const double alpha = 32768.0 / 65535.0;
    check_near(image.data[0], 0.0, 0.0);
    check_near(image.data[1], 0.2140482023 * alpha, 1e-7);
    check_near(image.data[2], alpha, 1e-7);
    check_near(image.data[3], alpha, 1e-7);
    rl_image_clear(&image);
}

static void test_grey_is_one_channel(void **state)
{
    (void)state;
    const unsigned char rows[] = {0, 0, 128, 0, 255, 1};
    struct png_writer writer;
    struct rl_image image = {0};
    png_begin(&writer, 2, 2, 8, 0);
    png_end(&writer, rows, sizeof rows);
    read_png(&image, &writer);
    assert_int_equal(image.channels, 1);
    assert_string_equal(image.channel_name[0], "Y");
    check_near(image.data[1], 0.21586050011, 1e-7);
    check_near(image.data[2], 1.0, 0.0);
    rl_image_clear(&image);
}

/* The gAMA chunk holds 100000/gamma. */
static void test_png_gamma_is_followed(void **state)
{
    (void)state;
    static const struct {
        unsigned gama;
        double decoded; /* of 128/255 */
    } cases[] = {
        {100000, 0.50196078431}, /* linear */
        {50000, 0.25196462899},  /* squared */
        {45455, 0.21951971},     /* power of 2.2, to which the library rounds (mpmath) */
    };
    const unsigned char row[] = {0, 128};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct png_writer writer;
        struct rl_image image = {0};
        unsigned char gama[4];
        png_u32(gama, cases[i].gama);
        png_begin(&writer, 1, 1, 8, 0);
        png_chunk(&writer, "gAMA", gama, sizeof gama);
        png_end(&writer, row, sizeof row);
        read_png(&image, &writer);
        check_near(image.data[0], cases[i].decoded, 1e-6);
        rl_image_clear(&image);
    }
}

static void test_other_formats(void **state)
{
    (void)state;
    struct rl_image image = {0};
    char path[PATH_MAX];
    temporary_path(&folder, path, "a.ppm");
    put(path, "P6 2 1 255\n\x80\x00\xff\x00\x00\x00", 17);
    check_ok(rl_image_read(&image, path, &error), &error);
    assert_int_equal(image.width, 2);
    assert_int_equal(image.channels, 3);
    check_near(image.data[0], 0.21586050011, 1e-7);
    check_near(image.data[2], 1.0, 0.0);
    rl_image_clear(&image);

    /* Floats are linear already, whatever they are. */
    const float values[] = {-2.0F, NAN, 40000.0F};
    char pfm[64] = "PF\n1 1\n-1.0\n";
    size_t head = strlen(pfm);
    memcpy(pfm + head, values, sizeof values);
    temporary_path(&folder, path, "a.pfm");
    put(path, pfm, head + sizeof values);
    check_ok(rl_image_read(&image, path, &error), &error);
    check_near(image.data[0], -2.0, 0.0);
    assert_true(isnan(image.data[1]));
    check_near(image.data[2], 40000.0, 0.0);
    rl_image_clear(&image);
}

static void test_nonfinite_values_are_kept(void **state)
{
    (void)state;
    struct rl_image image = {0};
    make(&image, 2, 1, 1);
    image.data[0] = 1.0F;
    image.data[1] = 2.0F;
    check_ok(rl_image_write(&image, exr, NULL, &error), &error);
    rl_image_clear(&image);
    char *bytes = NULL;
    size_t size = 0;
    check_ok(rl_file_read(&bytes, &size, exr, &error), &error);
    /* The two floats, too few to be worth packing, are the last of the file. */
    const float values[] = {NAN, INFINITY};
    const float expected[] = {1.0F, 2.0F};
    assert_memory_equal(bytes + size - sizeof values, expected, sizeof expected);
    memcpy(bytes + size - sizeof values, values, sizeof values);
    put(exr, bytes, size);
    free(bytes);
    check_ok(rl_image_read(&image, exr, &error), &error);
    assert_true(isnan(image.data[0]));
    assert_true(isinf(image.data[1]));
    rl_image_clear(&image);
}

/* Writes the box of an attribute in an EXR file's header. */
static void patch_box(char *bytes, size_t size, const char *name, const int32_t box[4])
{
    char mark[64];
    int length = snprintf(mark, sizeof mark, "%s%cbox2i%c", name, 0, 0);
    char *found = memmem(bytes, size, mark, (size_t)length);
    assert_non_null(found);
    memcpy(found + length + 4, box, 4 * sizeof *box);
}

static void patch_exr(const int32_t display[4], const int32_t data[4])
{
    struct rl_image image = {0};
    char *bytes = NULL;
    size_t size = 0;
    make(&image, 6, 4, 1);
    check_ok(rl_image_write(&image, exr, NULL, &error), &error);
    check_ok(rl_file_read(&bytes, &size, exr, &error), &error);
    patch_box(bytes, size, "displayWindow", display);
    if (data)
        patch_box(bytes, size, "dataWindow", data);
    put(exr, bytes, size);
    free(bytes);
    rl_image_clear(&image);
}

static void test_exr_display_window(void **state)
{
    (void)state;
    static const int32_t window[4] = {2, -1, 8, 2}; /* x 2 to 8, y -1 to 2; the data lie at 0, 0 to 5, 3 */
    struct rl_image image = {0};
    patch_exr(window, NULL);
    check_ok(rl_image_read(&image, exr, &error), &error);
    assert_int_equal(image.width, 7);
    assert_int_equal(image.height, 4);
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 7; x++) {
            int from_x = x + 2;
            int from_y = y - 1;
            bool stored = from_x < 6 && from_y >= 0;
            float expected = stored ? (float)(from_y * 6 + from_x) / 97.0F : 0.0F;
            check_near(*rl_image_pixel(&image, x, y), expected, 0.0);
        }
    }
    rl_image_clear(&image);
}

static void test_absurd_sizes_are_refused(void **state)
{
    (void)state;
    static const int32_t boxes[][4] = {
        {0, 0, 59999, 59999}, {0, 0, 1 << 30, 1 << 30},
        {0, 0, 5, 1 << 28},   {0, 0, 1 << 28, 3},
        {0, 0, 29999, 7999},  {0, 0, -1, -1},
        {5, 5, 0, 0},         {-(1 << 30), -(1 << 30), 1 << 30, 1 << 30},
        {0, 0, INT32_MAX, 0},
    };
    for (size_t i = 0; i < sizeof boxes / sizeof boxes[0]; i++) {
        struct rl_image image = {0};
        patch_exr(boxes[i], boxes[i]);
        check_fails(rl_image_read(&image, exr, &error), &error, RL_ERR_INPUT, exr);
        assert_null(image.data);
    }
    /* A small file of data in a huge picture would cost as much memory. */
    static const int32_t huge[4] = {0, 0, 59999, 59999};
    struct rl_image image = {0};
    patch_exr(huge, NULL);
    check_fails(rl_image_read(&image, exr, &error), &error, RL_ERR_INPUT, "60000 x 60000 pixels");

    struct png_writer writer;
    png_begin(&writer, 900000, 900000, 8, 2);
    png_end(&writer, (const unsigned char *)"", 1);
    put(png, writer.bytes, writer.size);
    check_fails(rl_image_read(&image, png, &error), &error, RL_ERR_INPUT, "900000 x 900000 pixels");
    assert_null(image.data);
}

static void test_what_is_no_image(void **state)
{
    (void)state;
    struct rl_image image = {0};
    char path[PATH_MAX];
    check_fails(rl_image_read(&image, folder.folder, &error), &error, RL_ERR_INPUT, "not a regular file");
    check_fails(rl_image_read(&image, "/dev/null", &error), &error, RL_ERR_INPUT, "not a regular file");
    temporary_path(&folder, path, "pipe.exr");
    assert_int_equal(mkfifo(path, 0666), 0);
    check_fails(rl_image_read(&image, path, &error), &error, RL_ERR_INPUT, "not a regular file");
    temporary_path(&folder, path, "missing.exr");
    check_fails(rl_image_read(&image, path, &error), &error, RL_ERR_INPUT,
                "missing.exr: cannot open: No such file or directory");
    assert_int_equal(rl_image_read(&image, path, NULL), RL_ERR_INPUT);
    static const char *const names[] = {"a.exr", "a.png", "a.jpg", "a.tif", "a.hdr", "a", "a.yaml"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        temporary_path(&folder, path, names[i]);
        put(path, "", 0);
        check_fails(rl_image_read(&image, path, &error), &error, RL_ERR_INPUT, "empty file");
        put(path, "camera:\n  position: [0, 0, 1]\n", 30);
        check_fails(rl_image_read(&image, path, &error), &error, RL_ERR_INPUT, names[i]);
        assert_int_equal(rl_image_read(&image, path, NULL), RL_ERR_INPUT);
    }
    assert_null(image.data);
}

static void test_truncated_files(void **state)
{
    (void)state;
    const char *const paths[] = {exr, png};
    struct rl_image image = {0};
    make(&image, 8, 4, 4);
    for (int i = 0; i < 2; i++) {
        char *bytes = NULL;
        size_t size = 0;
        check_ok(rl_image_write(&image, paths[i], NULL, &error), &error);
        check_ok(rl_file_read(&bytes, &size, paths[i], &error), &error);
        for (size_t kept = 1; kept < size; kept += kept + 20 < size ? 23 : 1) {
            struct rl_image back = {0};
            put(paths[i], bytes, kept);
            check_fails(rl_image_read(&back, paths[i], &error), &error, RL_ERR_INPUT, paths[i]);
            assert_null(back.data);
        }
        free(bytes);
    }
    rl_image_clear(&image);
}

/* Whatever is wrong inside, the answer is an image or one line. */
static void test_damaged_files(void **state)
{
    (void)state;
    const char *const paths[] = {exr, png};
    struct rl_image image = {0};
    make(&image, 8, 4, 4);
    for (int i = 0; i < 2; i++) {
        char *bytes = NULL;
        size_t size = 0;
        check_ok(rl_image_write(&image, paths[i], NULL, &error), &error);
        check_ok(rl_file_read(&bytes, &size, paths[i], &error), &error);
        for (size_t at = 0; at < size; at += 5) {
            struct rl_image back = {0};
            bytes[at] = (char)(bytes[at] ^ (1 << (at % 8)));
            put(paths[i], bytes, size);
            bytes[at] = (char)(bytes[at] ^ (1 << (at % 8)));
            int status = rl_image_read(&back, paths[i], &error);
            if (i == 1 || status != RL_OK) /* PNG has checksums: it always notices */
                check_fails(status, &error, RL_ERR_INPUT, paths[i]);
            assert_true(status == RL_OK || !back.data);
            rl_image_clear(&back);
        }
        free(bytes);
    }
    rl_image_clear(&image);
}

static void test_too_many_channels(void **state)
{
    (void)state;
    /* Multi-channel files are rare outside EXR: 17 channels of one pixel, written by hand. */
    struct rl_image image = {0};
    make(&image, 1, 1, RL_IMAGE_CHANNELS_MAX);
    check_ok(rl_image_write(&image, exr, NULL, &error), &error);
    char *bytes = NULL;
    size_t size = 0;
    check_ok(rl_file_read(&bytes, &size, exr, &error), &error);
    rl_image_clear(&image);
    char *list = memmem(bytes, size, "channels\0chlist\0", 16);
    assert_non_null(list);
    /* "C0" is followed by 16 bytes of its type; a copy of it, named D0, goes in front of the list's end. */
    char *length_field = list + 16;
    int32_t length = 0;
    memcpy(&length, length_field, 4);
    char *end = length_field + 4 + length - 1;
    char *more = malloc(size + 19);
    assert_non_null(more);
    size_t before = (size_t)(end - bytes);
    memcpy(more, bytes, before);
    memcpy(more + before, length_field + 4, 19);
    more[before] = 'D';
    memcpy(more + before + 19, end, size - before);
    length += 19;
    memcpy(more + (length_field - bytes), &length, 4);
    put(exr, more, size + 19);
    free(bytes);
    free(more);
    check_fails(rl_image_read(&image, exr, &error), &error, RL_ERR_INPUT, "17 channels, 1 to 16 expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_integers_are_decoded_from_srgb),
        cmocka_unit_test(test_grey_is_one_channel),
        cmocka_unit_test(test_png_gamma_is_followed),
        cmocka_unit_test(test_other_formats),
        cmocka_unit_test(test_nonfinite_values_are_kept),
        cmocka_unit_test(test_exr_display_window),
        cmocka_unit_test(test_absurd_sizes_are_refused),
        cmocka_unit_test(test_what_is_no_image),
        cmocka_unit_test(test_truncated_files),
        cmocka_unit_test(test_damaged_files),
        cmocka_unit_test(test_too_many_channels),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
