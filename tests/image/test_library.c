/* Loading the plug-in: once, from any thread, and with a clear word where it is missing. */
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/files.h"
#include "image/fixture.h"
#include "support/run.h"

enum { THREADS = 4 };

struct task {
    pthread_t thread;
    char path[PATH_MAX];
    int status;
    struct rl_error error;
};

static void *write_and_read(void *user)
{
    struct task *task = user;
    struct rl_image image = {0};
    struct rl_image back = {0};
    task->status = rl_image_allocate(&image, 32, 32, 4, &task->error);
    if (task->status == RL_OK)
        task->status = rl_image_write(&image, task->path, NULL, &task->error);
    if (task->status == RL_OK)
        task->status = rl_image_read(&back, task->path, &task->error);
    rl_image_clear(&image);
    rl_image_clear(&back);
    return NULL;
}

static int run_threads(void)
{
    static struct task task[THREADS];
    for (int i = 0; i < THREADS; i++) {
        char name[16];
        snprintf(name, sizeof name, "%d.%s", i, i % 2 ? "png" : "exr");
        temporary_path(&folder, task[i].path, name);
        if (pthread_create(&task[i].thread, NULL, write_and_read, &task[i]) != 0)
            abort();
    }
    int failed = 0;
    for (int i = 0; i < THREADS; i++) {
        pthread_join(task[i].thread, NULL);
        if (task[i].status != RL_OK)
            fprintf(stderr, "%s\n", task[i].error.message);
        failed += task[i].status != RL_OK;
    }
    return failed;
}

/* In a process of its own, where the plug-in has not been used yet, and which ends without a search for
 * leaks: gcc 12's LeakSanitizer crashes on libraries that were loaded by a thread which is gone. */
static void test_first_use_from_many_threads(void **state)
{
    (void)state;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0)
        _exit(run_threads());
    int status = -1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
}

static void test_version(void **state)
{
    (void)state;
    char version[64] = "";
    check_ok(rl_image_library(version, &error), &error);
    assert_in_range(strtol(version, NULL, 10), 2, 99);
}

/* A copy of this program in a folder with no plug-in, or a wrong one, beside it. */
static void run_elsewhere(char output[], size_t size, const char *plugin)
{
    char *bytes = NULL;
    size_t n = 0;
    char program[PATH_MAX];
    char path[PATH_MAX];
    temporary_path(&folder, program, "program");
    temporary_path(&folder, path, "roughlight-oiio.so");
    check_ok(rl_file_read(&bytes, &n, "/proc/self/exe", &error), &error);
    check_ok(rl_file_write(program, bytes, n, &error), &error);
    free(bytes);
    assert_int_equal(chmod(program, 0755), 0);
    if (plugin)
        check_ok(rl_file_write(path, plugin, strlen(plugin), &error), &error);
    assert_int_equal(run(output, size, program, "--library"), (unsigned char)RL_ERR_UNAVAILABLE);
}

static void test_missing_plugin(void **state)
{
    (void)state;
    char output[2048];
    run_elsewhere(output, sizeof output, NULL);
    assert_non_null(strstr(output, "roughlight-oiio.so: not found"));
    assert_non_null(strstr(output, "libopenimageio-dev"));
}

static void test_broken_plugin(void **state)
{
    (void)state;
    char output[2048];
    run_elsewhere(output, sizeof output, "not a library");
    assert_non_null(strstr(output, "cannot be read or written"));
    assert_non_null(strstr(output, "libopenimageio-dev"));
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--library") == 0) {
        char version[64] = "";
        int status = rl_image_library(version, &error);
        puts(status == RL_OK ? version : error.message);
        return (unsigned char)status;
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_first_use_from_many_threads),
        cmocka_unit_test(test_version),
        cmocka_unit_test(test_missing_plugin),
        cmocka_unit_test(test_broken_plugin),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
