/* PLY files: whole ones pass, cut ones never do, wherever they are cut. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "scene/mesh_import.h"
#include "support/check.h"

static struct rl_error error;

#define HEADER(format)                                                                                       \
    "ply\nformat " format                                                                                    \
    " 1.0\ncomment two triangles\nelement vertex 4\nproperty float x\nproperty float y\n"                    \
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"

static const char ascii[] = HEADER("ascii") "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

/* The same square. */
static size_t make_binary(char *data, const char *header, bool big_endian)
{
    static const float position[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    static const int face[2][3] = {{0, 1, 2}, {0, 2, 3}};
    size_t n = strlen(header);
    memcpy(data, header, n);
    for (int i = 0; i < 12; i++) {
        uint32_t bits;
        memcpy(&bits, &position[i / 3][i % 3], 4);
        for (int k = 0; k < 4; k++)
            data[n++] = (char)(bits >> 8 * (big_endian ? 3 - k : k));
    }
    for (int i = 0; i < 2; i++) {
        data[n++] = 3;
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 4; k++)
                data[n++] = (char)(face[i][c] >> 8 * (big_endian ? 3 - k : k));
    }
    data[n] = '\0';
    return n;
}

static int check_copy(const char *data, size_t size)
{
    char *copy = malloc(size + 1); /* of exactly this size, for the sanitizer */
    assert_non_null(copy);
    memcpy(copy, data, size);
    copy[size] = '\0';
    int status = rl_ply_check(copy, size, "x.ply", &error);
    free(copy);
    return status;
}

static void check_cuts(const char *data, size_t size, size_t needed)
{
    check_ok(check_copy(data, size), &error);
    for (size_t n = 0; n < size; n++) {
        int status = check_copy(data, n);
        assert_int_equal(status == RL_OK, n >= needed);
        if (status != RL_OK)
            assert_int_equal(strncmp(error.message, "x.ply:", 6), 0);
    }
}

static void test_cuts(void **state)
{
    (void)state;
    check_cuts(ascii, sizeof ascii - 1, sizeof ascii - 2); /* the last newline is no loss */
    char data[512];
    size_t n = make_binary(data, HEADER("binary_little_endian"), false);
    check_cuts(data, n, n);
    n = make_binary(data, HEADER("binary_big_endian"), true);
    check_cuts(data, n, n);
}

static void test_accepted(void **state)
{
    (void)state;
    static const char *const cases[] = {
        HEADER("ascii") "\n0 0 0\r\n 1 0 0 \n1\t1 0\n\n0 1e0 0\n3 0 1 2\n4 0 1 2 3",
        HEADER("ascii") "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\nwhat follows is nobody's\n",
        "ply\r\nformat ascii 1.0\r\nelement vertex 0\r\nend_header\r\n",
        /* Rows of nothing. */
        "ply\nformat ascii 1.0\nobj_info by hand\nelement vertex 99999999999\nend_header\n",
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        check_ok(check_copy(cases[i], strlen(cases[i])), &error);
}

static void test_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text, *words;
    } cases[] = {
        {"", "x.ply:1: found no PLY header"},
        {"plyometric\n", "x.ply:1: found no PLY header"},
        {"ply\nend_header\n", "x.ply:2: found a header without a format"},
        {"ply\nformat text 1.0\nend_header\n", "x.ply:2: found an unknown format"},
        {"ply\nformat ascii 1.0\nelement vertex\nend_header\n", "x.ply:3: found an element without a number"},
        {"ply\nformat ascii 1.0\nelement vertex -4\nend_header\n",
         "x.ply:3: found an element without a number"},
        {"ply\nformat ascii 1.0\nelement vertex 99999999999999999999\nend_header\n",
         "x.ply:3: found an element"},
        {"ply\nformat ascii 1.0\nproperty float x\nend_header\n", "x.ply:3: found a property out of place"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n",
         "x.ply:4: found an unknown type"},
        {"ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_index\nend_header\n",
         "x.ply:4: found an unknown type"},
        {HEADER("ascii") "0 0 0\n1 0 0\n1 1\n0 1 0\n3 0 1 2\n3 0 2 3\n",
         "cut off after 2 of 4 rows of vertex"},
        {HEADER("ascii") "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 2 3\n",
         "cut off after 1 of 2 rows of face"},
        {HEADER("ascii") "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 4\n",
         "found the vertex index 4 in row 1 of face, expected 0 to 3"},
        {HEADER("ascii") "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 -1\n3 0 2 3\n",
         "found the vertex index -1 in row 0"},
        {HEADER("ascii") "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1\n3 0 2 3\n",
         "found a list of 2 in row 0 of face"},
        {HEADER("ascii") "0 0 0\n1 0 0\n1 1 0\n0 1 0\nnan 0 1\n3 0 2 3\n",
         "found a list of nan in row 0 of face"},
        {HEADER("ascii") "0 0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
         "more values than announced in row 0"},
        {HEADER("ascii") "0 0 zero\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
         "cut off after 0 of 4 rows of vertex"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        check_fails(check_copy(cases[i].text, strlen(cases[i].text)), &error, RL_ERR_INPUT, cases[i].words);
}

/* A list that claims four thousand million entries ends with the file. */
static void test_endless_list(void **state)
{
    (void)state;
    static const char header[] = "ply\nformat binary_little_endian 1.0\nelement face 1\n"
                                 "property list uint double other\nend_header\n";
    char data[sizeof header + 16];
    memcpy(data, header, sizeof header - 1);
    memset(data + sizeof header - 1, 0xff, 16);
    check_fails(check_copy(data, sizeof header - 1 + 16), &error, RL_ERR_INPUT,
                "cut off after 0 of 1 rows of face");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cuts),
        cmocka_unit_test(test_accepted),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_endless_list),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
