/* A case's parameters as settings; references that are kept, and what is not believed of them. */
#include <glob.h>
#include <limits.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/files.h"
#include "studies/bench.h"
#include "studies/planner.h"
#include "support/check.h"
#include "support/temporary.h"

static void test_settings(void **state)
{
    (void)state;
    struct rl_settings s;
    struct rl_error error = {0};
    assert_int_equal(rl_bench_settings(&s,
                                       "method=random samples=64 rr=2.5 normal_bits=float env_size=1024 "
                                       "env_format=rgba16f width=64 height=48 tolerance=1e-3 seeds=8 "
                                       "interpolation=gouraud",
                                       &error),
                     RL_OK);
    assert_string_equal(s.method, "random");
    assert_true(s.samples == 64 && s.rr == 2.5 && s.normal_bits == RL_NORMAL_BITS_FLOAT &&
                s.env_size == 1024);
    assert_true(s.env_format == RL_TEXEL_RGBA16F && s.width == 64 && s.height == 48 && s.tolerance == 1e-3);
    assert_int_equal(s.interpolation, RL_INTERPOLATION_GOURAUD);
    assert_int_equal(rl_bench_settings(&s, "", &error), RL_OK); /* the paper's */
    assert_int_equal(s.interpolation, RL_INTERPOLATION_OF_MATERIAL);
    assert_true(s.normal_bits == 8 && s.env_size == 256 && s.method == NULL && s.rr == 0.0);
    assert_int_equal(rl_bench_settings(&s, "method=none", &error), RL_OK);
    assert_null(s.method);
    static const char *const bad[] = {"method=magic",    "samples=4.5",       "samples=100000",
                                      "rr=-1",           "normal_bits=two",   "env_size=1e300",
                                      "env_format=jpeg", "interpolation=flat"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        assert_int_equal(rl_bench_settings(&s, bad[i], &error), RL_ERR_INPUT);
}

/* The last note, and how many there were. */
struct notes {
    int n;
    char last[1200];
};

static void take_note(void *user, const char *text)
{
    struct notes *notes = user;
    notes->n++;
    snprintf(notes->last, sizeof notes->last, "%s", text);
}

enum { EDGE = 16, CHANNELS = 4, VALUES = EDGE * EDGE * CHANNELS };

/* The reference of 16x16 pixels at an R_r, by a bench that has nothing in memory. */
static void reference(float out[VALUES], const char *cache, const char *parameters, struct notes *notes)
{
    struct rl_bench bench;
    struct rl_scene scene;
    struct rl_error error = {0};
    const struct rl_progress progress = {.note = take_note, .user = notes};
    const struct rl_image *image;
    *notes = (struct notes){0};
    check_ok(rl_bench_open(&bench, "auto", 0, cache, &progress, &error), &error);
    check_ok(rl_study_scene_load(&scene, "sphere-quad", &error), &error);
    check_ok(rl_bench_reference(&image, &bench, &scene, parameters, RL_LIGHT_FROM_POINT, &error), &error);
    assert_true(image->width == EDGE && image->height == EDGE && image->channels == CHANNELS);
    memcpy(out, image->data, VALUES * sizeof *out);
    rl_bench_close(&bench);
    rl_scene_clear(&scene);
}

static void only_file(char path[PATH_MAX], const struct temporary *folder)
{
    char pattern[PATH_MAX];
    glob_t found;
    temporary_path(folder, pattern, "reference-*.exr");
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    assert_int_equal(found.gl_pathc, 1);
    snprintf(path, PATH_MAX, "%s", found.gl_pathv[0]);
    globfree(&found);
}

/* Only a file that holds the key of the reference asked for is taken for it, whatever its name is. */
static void test_cached(void **state)
{
    (void)state;
    static const char rough[] = "rr=10 width=16 height=16", smooth[] = "rr=300 width=16 height=16";
    struct temporary folder = {0}, other = {0};
    char path[PATH_MAX], other_path[PATH_MAX];
    static float first[VALUES], again[VALUES];
    struct notes notes;
    temporary_make(&folder);
    temporary_make(&other);
    reference(again, other.folder, rough, &notes);
    only_file(other_path, &other);
    reference(first, folder.folder, smooth, &notes);
    only_file(path, &folder);
    assert_int_equal(notes.n, 0);
    assert_memory_not_equal(first, again, sizeof first);

    struct stat kept, now;
    assert_int_equal(stat(path, &kept), 0);
    reference(again, folder.folder, smooth, &notes);
    assert_memory_equal(first, again, sizeof first);
    assert_int_equal(stat(path, &now), 0);
    assert_true(notes.n == 0 && now.st_ino == kept.st_ino); /* read, not made anew */

    /* Another reference of the same size, one without a key, and no picture at all. */
    struct rl_error error = {0};
    struct rl_image image = {0};
    check_ok(rl_image_read(&image, path, &error), &error);
    check_ok(rl_image_set_string(&image, "roughlight:key", "", &error), &error);
    for (int i = 0; i < 3; i++) {
        char *data = NULL;
        size_t size = 0;
        check_ok(rl_file_read(&data, &size, other_path, &error), &error);
        if (i == 0)
            check_ok(rl_file_write(path, data, size, &error), &error);
        else if (i == 1)
            check_ok(rl_image_write(&image, path, NULL, &error), &error);
        else
            check_ok(rl_file_write(path, data, size / 2, &error), &error);
        free(data);
        reference(again, folder.folder, smooth, &notes);
        assert_memory_equal(first, again, sizeof first);
        assert_int_equal(notes.n, 1);
        assert_non_null(strstr(notes.last, path));
        assert_non_null(strstr(notes.last, i < 2 ? ": not the reference of that name; computed again"
                                                 : "; computed again"));
        reference(again, folder.folder, smooth, &notes); /* it was put in that one's place */
        assert_memory_equal(first, again, sizeof first);
        assert_int_equal(notes.n, 0);
    }
    rl_image_clear(&image);
    temporary_remove(&folder);
    temporary_remove(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_settings), cmocka_unit_test(test_cached)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
