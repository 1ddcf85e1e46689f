/* Whole files: read, replaced at once or not at all. */
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
#include "support/check.h"
#include "support/temporary.h"

static struct rl_error error;
static struct temporary folder;

static int set_up(void **state)
{
    (void)state;
    temporary_make(&folder);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

static void assert_content(const char *path, const char *expected, size_t expected_size)
{
    char *data = NULL;
    size_t size = 0;
    check_ok(rl_file_read(&data, &size, path, &error), &error);
    assert_int_equal(size, expected_size);
    assert_memory_equal(data, expected, size);
    assert_int_equal(data[size], 0);
    free(data);
}

static bool exists(const char *path)
{
    return access(path, F_OK) == 0;
}

static void test_write_and_read(void **state)
{
    (void)state;
    char path[PATH_MAX];
    temporary_path(&folder, path, "a.bin");
    check_ok(rl_file_write(path, "one\0two", 7, &error), &error);
    assert_content(path, "one\0two", 7);
    check_ok(rl_file_write(path, "", 0, &error), &error);
    assert_content(path, "", 0);

    enum { LARGE = 3 << 20 };
    char *large = malloc(LARGE);
    assert_non_null(large);
    for (size_t i = 0; i < LARGE; i++)
        large[i] = (char)(i * 31 >> 3);
    check_ok(rl_file_write(path, large, LARGE, &error), &error);
    assert_content(path, large, LARGE);
    free(large);
}

static void test_read_refuses(void **state)
{
    (void)state;
    char *data = NULL;
    size_t size = 0;
    char path[PATH_MAX];
    temporary_path(&folder, path, "missing");
    check_fails(rl_file_read(&data, &size, path, &error), &error, RL_ERR_INPUT,
                "missing: cannot open: No such file");
    check_fails(rl_file_read(&data, &size, folder.folder, &error), &error, RL_ERR_INPUT,
                "not a regular file");
    check_fails(rl_file_read(&data, &size, "/dev/zero", &error), &error, RL_ERR_INPUT, "not a regular file");
    temporary_path(&folder, path, "pipe");
    assert_int_equal(mkfifo(path, 0666), 0);
    check_fails(rl_file_read(&data, &size, path, &error), &error, RL_ERR_INPUT, "not a regular file");
    temporary_path(&folder, path, "sparse");
    check_ok(rl_file_write(path, "", 0, &error), &error);
    assert_int_equal(truncate(path, (1LL << 30) + 1), 0);
    check_fails(rl_file_read(&data, &size, path, &error), &error, RL_ERR_INPUT, "at most 1 GiB");
    assert_null(data);
}

static void test_begin_and_commit(void **state)
{
    (void)state;
    char path[PATH_MAX];
    char temporary[PATH_MAX];
    temporary_path(&folder, path, "b.exr");
    check_ok(rl_file_write(path, "old", 3, &error), &error);
    check_ok(rl_file_begin(temporary, sizeof temporary, path, &error), &error);
    assert_string_equal(temporary + strlen(temporary) - 4, ".exr");
    assert_true(exists(temporary));
    FILE *file = fopen(temporary, "w");
    assert_non_null(file);
    fputs("new", file);
    fclose(file);
    assert_content(path, "old", 3);
    check_ok(rl_file_commit(temporary, path, &error), &error);
    assert_content(path, "new", 3);
    assert_false(exists(temporary));

    check_ok(rl_file_begin(temporary, sizeof temporary, path, &error), &error);
    rl_file_abandon(temporary);
    assert_false(exists(temporary));
    assert_content(path, "new", 3);
}

static void test_begin_refuses(void **state)
{
    (void)state;
    char path[PATH_MAX];
    char temporary[PATH_MAX];
    char small[8];
    check_fails(rl_file_begin(temporary, sizeof temporary, folder.folder, &error), &error, RL_ERR_SYSTEM,
                "is a directory");
    check_fails(rl_file_begin(temporary, sizeof temporary, "/dev/null", &error), &error, RL_ERR_SYSTEM,
                "device or pipe");
    temporary_path(&folder, path, "missing/x");
    check_fails(rl_file_begin(temporary, sizeof temporary, path, &error), &error, RL_ERR_SYSTEM,
                "No such file");
    check_fails(rl_file_begin(temporary, sizeof temporary, "", &error), &error, RL_ERR_SYSTEM,
                "a file name is expected");
    temporary_path(&folder, path, "x");
    check_fails(rl_file_begin(small, sizeof small, path, &error), &error, RL_ERR_SYSTEM, "too long");
    char name[300];
    memset(name, 'n', sizeof name);
    name[sizeof name - 1] = '\0';
    temporary_path(&folder, path, name);
    check_fails(rl_file_begin(temporary, sizeof temporary, path, &error), &error, RL_ERR_SYSTEM,
                "File name too long");
}

static void test_names_without_folder_or_ending(void **state)
{
    (void)state;
    static const char *const names[] = {"plain", ".hidden", "a.tar.gz", "./b", "-c"};
    char before[PATH_MAX];
    assert_non_null(getcwd(before, sizeof before));
    assert_int_equal(chdir(folder.folder), 0);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        check_ok(rl_file_write(names[i], "x", 1, &error), &error);
        assert_content(names[i], "x", 1);
    }
    assert_int_equal(chdir(before), 0);
}

static void test_commit_to_a_vanished_folder(void **state)
{
    (void)state;
    char path[PATH_MAX];
    char other[PATH_MAX];
    char temporary[PATH_MAX];
    temporary_path(&folder, path, "c");
    temporary_path(&folder, other, "gone/c");
    check_ok(rl_file_begin(temporary, sizeof temporary, path, &error), &error);
    check_fails(rl_file_commit(temporary, other, &error), &error, RL_ERR_SYSTEM, "gone/c: cannot replace");
    assert_false(exists(temporary));
    check_fails(rl_file_commit(temporary, path, &error), &error, RL_ERR_SYSTEM,
                "c: cannot flush: No such file");
}

static void test_full_disk(void **state)
{
    (void)state;
    char disk[PATH_MAX];
    char path[PATH_MAX];
    char content[4096] = "";
    temporary_path(&folder, disk, "disk");
    temporary_path(&folder, path, "disk/full");
    check_ok(rl_directory_create(disk, &error), &error);
    check_ok(rl_file_write(path, "old", 3, &error), &error);
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        struct rlimit limit = {1000, 1000};
        signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &limit);
        int status = rl_file_write(path, content, sizeof content, &error);
        _exit(status == RL_ERR_SYSTEM && strstr(error.message, strerror(EFBIG)) ? 0 : 1);
    }
    int status = -1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    assert_content(path, "old", 3);
    /* Nothing else is left there. */
    assert_int_equal(unlink(path), 0);
    assert_int_equal(rmdir(disk), 0);
}

/* What a killed writer left goes with the next one; what one leaves that still runs stays. */
static void test_orphans(void **state)
{
    (void)state;
    char path[PATH_MAX], orphan[PATH_MAX], next[PATH_MAX];
    temporary_path(&folder, path, "orphan.txt");
    check_ok(rl_file_begin(next, sizeof next, path, &error), &error);
    const char *number = strrchr(next, '.');
    while (number > next && number[-1] != '.')
        number--;
    pid_t child = fork();
    if (child == 0)
        _exit(rl_file_begin(orphan, sizeof orphan, path, NULL) == RL_OK ? 0 : 1);
    int status = 1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    snprintf(orphan, sizeof orphan, "%.*s%ld.txt", (int)(number - next), next, (long)child);
    assert_true(exists(orphan));
    check_ok(rl_file_begin(next, sizeof next, path, &error), &error);
    assert_true(exists(next) && !exists(orphan));
    /* The process above all, which always runs. */
    snprintf(orphan, sizeof orphan, "%.*s1.txt", (int)(number - next), next);
    FILE *other = fopen(orphan, "w");
    assert_non_null(other);
    fclose(other);
    check_ok(rl_file_begin(next, sizeof next, path, &error), &error);
    assert_true(exists(next) && exists(orphan));
    rl_file_abandon(next);
    unlink(orphan);
}

static void test_directory_create(void **state)
{
    (void)state;
    char path[PATH_MAX];
    struct stat info;
    temporary_path(&folder, path, "d/e/f");
    check_ok(rl_directory_create(path, &error), &error);
    check_ok(rl_directory_create(path, &error), &error);
    assert_int_equal(stat(path, &info), 0);
    assert_true(S_ISDIR(info.st_mode));
    temporary_path(&folder, path, "d//g/");
    check_ok(rl_directory_create(path, &error), &error);
    check_ok(rl_directory_create("/", &error), &error);
    check_ok(rl_directory_create(".", &error), &error);

    temporary_path(&folder, path, "d/file");
    check_ok(rl_file_write(path, "", 0, &error), &error);
    check_fails(rl_directory_create(path, &error), &error, RL_ERR_SYSTEM, "exists and is not a folder");
    temporary_path(&folder, path, "d/file/g");
    check_fails(rl_directory_create(path, &error), &error, RL_ERR_SYSTEM, "Not a directory");
    check_fails(rl_directory_create("", &error), &error, RL_ERR_SYSTEM, "not a usable folder name");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_write_and_read),
        cmocka_unit_test(test_read_refuses),
        cmocka_unit_test(test_begin_and_commit),
        cmocka_unit_test(test_begin_refuses),
        cmocka_unit_test(test_names_without_folder_or_ending),
        cmocka_unit_test(test_commit_to_a_vanished_folder),
        cmocka_unit_test(test_full_disk),
        cmocka_unit_test(test_orphans),
        cmocka_unit_test(test_directory_create),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
