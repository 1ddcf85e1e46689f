/* The small parts: hash, progress, clock, and what the machine says of itself. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "base/clock.h"
#include "base/hash.h"
#include "base/machine.h"
#include "base/progress.h"
#include "base/simd.h"
#include "base/version.h"
#include "support/check.h"

/* Test vectors of the FNV reference code (Noll's test_fnv.c, FNV-1a 64 bit). */
static void test_hash(void **state)
{
    (void)state;
    static const struct {
        const char *text, *hash;
    } cases[] = {
        {"", "cbf29ce484222325"},
        {"a", "af63dc4c8601ec8c"},
        {"foobar", "85944171f73967e8"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[RL_HASH_TEXT];
        rl_hash_text(text, rl_hash_bytes(RL_HASH_START, cases[i].text, strlen(cases[i].text)));
        assert_string_equal(text, cases[i].hash);
    }
    /* In pieces as in one. */
    uint64_t hash = rl_hash_bytes(rl_hash_bytes(RL_HASH_START, "foo", 3), "bar", 3);
    assert_true(hash == UINT64_C(0x85944171f73967e8));
    char text[RL_HASH_TEXT];
    rl_hash_text(text, 15);
    assert_string_equal(text, "000000000000000f");
}

struct seen {
    size_t done, total, all_done, all_total;
    double seconds_left;
    const char *what, *noted;
    bool stop;
};

static void update(void *user, const char *what, size_t done, size_t total)
{
    struct seen *seen = user;
    seen->what = what;
    seen->done = done;
    seen->total = total;
}

static bool cancelled(void *user)
{
    return ((struct seen *)user)->stop;
}

static void overall(void *user, size_t done, size_t total, double seconds_left)
{
    struct seen *seen = user;
    seen->all_done = done;
    seen->all_total = total;
    seen->seconds_left = seconds_left;
}

static void note(void *user, const char *text)
{
    ((struct seen *)user)->noted = text;
}

static void test_progress(void **state)
{
    (void)state;
    rl_progress_update(NULL, "nobody looks", 1, 2);
    assert_false(rl_progress_cancelled(NULL));
    const struct rl_progress silent = {0};
    rl_progress_update(&silent, "nobody looks", 1, 2);
    rl_progress_overall(NULL, 1, 2, 3.0);
    rl_progress_overall(&silent, 1, 2, 3.0);
    rl_progress_note(NULL, "nobody listens");
    rl_progress_note(&silent, "nobody listens");
    assert_false(rl_progress_cancelled(&silent));

    struct seen seen = {0};
    const struct rl_progress progress = {update, cancelled, overall, note, &seen};
    rl_progress_update(&progress, "tiles", 3, 8);
    assert_string_equal(seen.what, "tiles");
    assert_int_equal(seen.done, 3);
    assert_int_equal(seen.total, 8);
    rl_progress_overall(&progress, 5, 20, 1.5);
    assert_true(seen.all_done == 5 && seen.all_total == 20 && seen.seconds_left == 1.5);
    rl_progress_note(&progress, "a folder");
    assert_string_equal(seen.noted, "a folder");
    assert_false(rl_progress_cancelled(&progress));
    seen.stop = true;
    assert_true(rl_progress_cancelled(&progress));
}

static void test_clock_runs_forward(void **state)
{
    (void)state;
    double last = rl_clock_seconds();
    for (int i = 0; i < 1000; i++) {
        double now = rl_clock_seconds();
        assert_true(now >= last);
        last = now;
    }
}

static void test_machine(void **state)
{
    (void)state;
    char text[256] = "";
    rl_machine_cpu(text, sizeof text);
    assert_true(text[0] != '\0' && !strpbrk(text, "\n\t"));
    rl_machine_system(text, sizeof text);
    assert_non_null(strstr(text, "Linux"));
    assert_null(strpbrk(text, "\n\t"));
    char small[4];
    rl_machine_system(small, sizeof small);
    assert_int_equal(strlen(small), 3);
    assert_in_range(rl_machine_threads(), 1, 65536);
}

/* What this process does is in the count, to within the ticks of its beginning and its end. */
static void test_machine_busy(void **state)
{
    (void)state;
    double before = rl_machine_busy_seconds();
    clock_t start = clock();
    while (clock() - start < CLOCKS_PER_SEC / 5)
        ;
    double busy = rl_machine_busy_seconds() - before;
    assert_true(busy >= 0.15 && busy < 60.0);
}

/* The variable lowers the choice and never raises it; what it may not say is refused in one line. */
static void test_simd(void **state)
{
    (void)state;
    struct rl_error error;
    unsetenv("ROUGHLIGHT_SIMD");
    enum rl_simd best = rl_simd_best();
    print_message("simd %s\n", rl_simd_name(best));
    for (int i = 0; i < RL_SIMD_COUNT; i++) {
        setenv("ROUGHLIGHT_SIMD", rl_simd_name((enum rl_simd)i), 1);
        if (i <= (int)best) {
            check_ok(rl_simd_check(&error), &error);
            assert_int_equal(rl_simd_best(), i);
        } else {
            check_fails(rl_simd_check(&error), &error, RL_ERR_INPUT, "which is what this machine has");
            assert_int_equal(rl_simd_best(), best);
        }
    }
    setenv("ROUGHLIGHT_SIMD", "AVX2", 1);
    check_fails(rl_simd_check(&error), &error, RL_ERR_INPUT, "found 'AVX2', expected plain, avx2 or avx512");
    assert_int_equal(rl_simd_best(), best);
    setenv("ROUGHLIGHT_SIMD", "", 1);
    check_ok(rl_simd_check(&error), &error);
    unsetenv("ROUGHLIGHT_SIMD");
}

static void test_version(void **state)
{
    (void)state;
    assert_non_null(strchr(rl_version.version, '.'));
    assert_true(strcmp(rl_version.commit, "unknown") == 0 || strlen(rl_version.commit) == 12);
    assert_int_equal(strspn(rl_version.code, "0123456789abcdef"), 16);
    assert_true(rl_version.compiler[0] != '\0');
    assert_non_null(strstr(rl_version.cflags, "-std=c17"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hash),
        cmocka_unit_test(test_progress),
        cmocka_unit_test(test_clock_runs_forward),
        cmocka_unit_test(test_machine),
        cmocka_unit_test(test_machine_busy),
        cmocka_unit_test(test_simd),
        cmocka_unit_test(test_version),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
