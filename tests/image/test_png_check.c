/* Whether a PNG file is whole: each way in which it may not be, and what is said. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "image/fixture.h"
#include "image/png_check.h"
#include "image/png_writer.h"

static int check(const void *bytes, size_t size)
{
    FILE *file = fopen(png, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
    return rl_png_check(png, &error);
}

/* 8 of signature, 25 of IHDR, 12 + 13 of IDAT, 12 of IEND */
enum { IDAT = 33, IEND = 58, SIZE = 70 };

static void make_png(struct png_writer *writer)
{
    const unsigned char row[] = {0, 128};
    png_begin(writer, 1, 1, 8, 0);
    png_end(writer, row, sizeof row);
    assert_int_equal(writer->size, SIZE);
}

static void test_whole_files_pass(void **state)
{
    (void)state;
    struct png_writer writer = {0};
    make_png(&writer);
    check_ok(check(writer.bytes, SIZE), &error);
    /* What comes after IEND is nobody's business. */
    check_ok(check(writer.bytes, SIZE + 5), &error);
}

static void test_chunks_longer_than_the_buffer_pass(void **state)
{
    (void)state;
    static struct png_writer writer;
    unsigned char text[5000];
    memset(text, 't', sizeof text);
    png_begin(&writer, 1, 1, 8, 0);
    png_chunk(&writer, "tEXt", text, sizeof text);
    png_end(&writer, (const unsigned char *)"\0\x80", 2);
    check_ok(check(writer.bytes, writer.size), &error);
    writer.bytes[8 + 25 + 8 + 4999] ^= 1;
    check_fails(check(writer.bytes, writer.size), &error, RL_ERR_INPUT,
                "chunk tEXt at byte 33 does not match");
}

static void test_other_files_pass(void **state)
{
    (void)state;
    check_ok(check("", 0), &error);
    check_ok(check("\x89P", 2), &error);
    check_ok(check("P6 1 1 255\n", 11), &error);
}

static void test_damage_is_named(void **state)
{
    (void)state;
    static const struct {
        size_t at, size; /* the byte that is changed, if there is one; how much of the file there is */
        int to;
        const char *words;
    } cases[] = {
        {4, SIZE, '\n', "first 8 bytes"},
        {0, 6, 0x89, "first 8 bytes"},
        {0, IDAT + 5, 0x89, "ends at byte 33"},
        {0, IDAT + 20, 0x89, "chunk IDAT at byte 33 is cut short"},
        {0, IEND - 2, 0x89, "chunk IDAT at byte 33 is cut short"},
        {0, IEND, 0x89, "ends at byte 58 without its last chunk, IEND"},
        {0, SIZE - 1, 0x89, "chunk IEND at byte 58 is cut short"},
        {IDAT + 10, SIZE, 0, "chunk IDAT at byte 33 does not match its checksum"},
        {IEND - 1, SIZE, 0, "chunk IDAT at byte 33 does not match its checksum"},
        {IDAT, SIZE, 0xff, "chunk IDAT at byte 33 is cut short"},
        {IDAT + 5, SIZE, '\n', "no chunk at byte 33"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct png_writer writer;
        make_png(&writer);
        writer.bytes[cases[i].at] = (unsigned char)cases[i].to;
        check_fails(check(writer.bytes, cases[i].size), &error, RL_ERR_INPUT, cases[i].words);
        assert_non_null(strstr(error.message, png));
    }
}

static void test_missing_file(void **state)
{
    (void)state;
    check_fails(rl_png_check("/nowhere.png", &error), &error, RL_ERR_INPUT, "cannot open");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whole_files_pass), cmocka_unit_test(test_chunks_longer_than_the_buffer_pass),
        cmocka_unit_test(test_other_files_pass), cmocka_unit_test(test_damage_is_named),
        cmocka_unit_test(test_missing_file),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
