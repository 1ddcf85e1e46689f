/* Images and places that cannot be written: one clear error, and nothing is left half-written. */
#include <dirent.h>
#include <errno.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/files.h"
#include "image/fixture.h"

static int count_files(void)
{
    DIR *directory = opendir(folder.folder);
    assert_non_null(directory);
    int n = 0;
    for (const struct dirent *entry; (entry = readdir(directory));)
        n += entry->d_name[0] != '.' || strlen(entry->d_name) > 2;
    closedir(directory);
    return n;
}

static void test_nonfinite_images_are_refused(void **state)
{
    (void)state;
    struct rl_image image = {0};
    struct rl_write_report report;
    make(&image, 4, 3, 4);
    rl_image_pixel(&image, 2, 1)[1] = NAN;
    rl_image_pixel(&image, 3, 1)[0] = INFINITY;
    rl_image_pixel(&image, 0, 2)[3] = -INFINITY;
    check_ok(rl_file_write(exr, "before", 6, &error), &error);
    int files = count_files();
    check_fails(rl_image_write(&image, exr, &report, &error), &error, RL_ERR_CHECK,
                "3 of 48 values are NaN or infinite, the first at x 2, y 1, channel G");
    assert_int_equal(report.nonfinite, 3);
    check_fails(rl_image_write(&image, png, NULL, &error), &error, RL_ERR_CHECK, "3 of 48");
    char *content = NULL;
    size_t size = 0;
    check_ok(rl_file_read(&content, &size, exr, &error), &error);
    assert_string_equal(content, "before");
    free(content);
    assert_int_equal(count_files(), files);
    rl_image_clear(&image);
}

static void test_reserved_attributes_are_refused(void **state)
{
    (void)state;
    static const char *const names[] = {"compression", "oiio:ColorSpace", "openexr:dwaCompressionLevel",
                                        "PixelAspectRatio", "Compression"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct rl_image image = {0};
        make(&image, 1, 1, 3);
        check_ok(rl_image_set_string(&image, names[i], "x", &error), &error);
        check_fails(rl_image_write(&image, exr, NULL, &error), &error, RL_ERR_INPUT, names[i]);
        rl_image_clear(&image);
    }
}

static void test_unwritable_places(void **state)
{
    (void)state;
    char directory[PATH_MAX];
    char missing[PATH_MAX];
    char below_file[PATH_MAX];
    temporary_path(&folder, directory, "folder.exr");
    temporary_path(&folder, missing, "missing/a.exr");
    temporary_path(&folder, below_file, "file/a.exr");
    assert_int_equal(mkdir(directory, 0777), 0);
    char file[PATH_MAX];
    temporary_path(&folder, file, "file");
    check_ok(rl_file_write(file, "", 0, &error), &error);
    struct rl_image image = {0};
    make(&image, 2, 2, 4);
    check_fails(rl_image_write(&image, directory, NULL, &error), &error, RL_ERR_SYSTEM,
                "folder.exr: is a directory");
    check_fails(rl_image_write(&image, missing, NULL, &error), &error, RL_ERR_SYSTEM,
                "missing/a.exr: cannot write: No such file or directory");
    check_fails(rl_image_write(&image, below_file, NULL, &error), &error, RL_ERR_SYSTEM, "Not a directory");
    check_fails(rl_image_write(&image, "/proc/a.png", NULL, &error), &error, RL_ERR_SYSTEM,
                "/proc/a.png: cannot write");

    static const char *const endings[] = {"a.jpg", "a", "a.exr.txt", "exr", ".exr/a", ""};
    for (size_t i = 0; i < sizeof endings / sizeof endings[0]; i++)
        check_fails(rl_image_write(&image, endings[i], NULL, &error), &error, RL_ERR_INPUT, ".exr or .png");
    struct rl_image empty = {0};
    check_fails(rl_image_write(&empty, exr, NULL, &error), &error, RL_ERR_INPUT, "empty image");
    rl_image_clear(&image);
}

/* In a process of its own, which may write no file over 1000 bytes: a full disk, to the code. */
static int write_on_full_disk(void)
{
    struct rl_image image = {0};
    struct rlimit limit = {1000, 1000};
    make(&image, 64, 64, 4);
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    int status = rl_image_write(&image, exr, NULL, &error);
    bool as_expected =
        status == RL_ERR_SYSTEM && strstr(error.message, strerror(EFBIG)) && strstr(error.message, exr);
    rl_image_clear(&image);
    return as_expected ? 0 : 1;
}

static void test_full_disk_leaves_the_old_file(void **state)
{
    (void)state;
    struct rl_image old = {0};
    struct rl_image back = {0};
    make(&old, 2, 2, 4);
    check_ok(rl_image_write(&old, exr, NULL, &error), &error);
    int files = count_files();
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        _exit(write_on_full_disk());
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    check_ok(rl_image_read(&back, exr, &error), &error);
    assert_same_pixels(&old, &back);
    assert_int_equal(count_files(), files);
    rl_image_clear(&old);
    rl_image_clear(&back);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nonfinite_images_are_refused),
        cmocka_unit_test(test_reserved_attributes_are_refused),
        cmocka_unit_test(test_unwritable_places),
        cmocka_unit_test(test_full_disk_leaves_the_old_file),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
