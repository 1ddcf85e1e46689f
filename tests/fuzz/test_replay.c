/* Replaying an input must be able to fail: a harness with a fault of each kind, chosen by its input. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include <cmocka.h>

#include "support/replay.h"
#include "support/temporary.h"

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

static int faulty(const uint8_t *data, size_t size)
{
    switch (size > 0 ? data[0] : 'o') {
    case 'a':
        abort();
    case 's':
        signal(SIGSEGV, SIG_DFL); /* cmocka's handler would make it an exit code */
        return raise(SIGSEGV);
    case 'e':
        exit(1); /* as sanitizers do */
    case 'w':
        for (;;)
            nanosleep(&(struct timespec){.tv_sec = 1}, NULL);
    case 'r':
        return -1;
    default:
        return 0;
    }
}

static void test_faults(void **state)
{
    (void)state;
    static const struct {
        const char *input, *why; /* NULL: it passes */
    } row[] = {
        {"", NULL},
        {"ok", NULL},
        {"abort", "Abort"},
        {"segfault", "Segmentation"},
        {"exit", "exit code 1"},
        {"wait", "not done after 1 s"},
        {"refuse", "exit code 4"},
    };
    char path[PATH_MAX], why[128];
    temporary_path(&folder, path, "input");
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        FILE *file = fopen(path, "wb");
        assert_non_null(file);
        fputs(row[i].input, file);
        fclose(file);
        snprintf(why, sizeof why, "nothing");
        bool passed = replay(why, sizeof why, faulty, path, 1);
        if (passed != !row[i].why || !strstr(why, row[i].why ? row[i].why : "")) {
            print_error("'%s': %s: %s\n", row[i].input, passed ? "passed" : "failed", why);
            fail();
        }
    }
    remove(path);
    assert_false(replay(why, sizeof why, faulty, path, 1));
    assert_string_equal(why, "the file cannot be read");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_faults),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
