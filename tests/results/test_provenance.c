/* Where results come from: the environment hash changes with what can change a result, and with nothing else. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "results/provenance.h"

static void test_environment(void **state)
{
    (void)state;
    struct rl_provenance p, q;
    char base[RL_HASH_TEXT], other[RL_HASH_TEXT];
    rl_provenance_fill(&p, 2, "osmesa", "llvmpipe", "4.5");
    rl_provenance_environment(&p, base);

    q = p;
    snprintf(q.time, sizeof q.time, "2001-01-01T00:00:00Z");
    rl_provenance_environment(&q, other);
    assert_string_equal(base, other);
    /* The same sources may be committed many times. */
    snprintf(q.commit, sizeof q.commit, "0123456789ab");
    q.dirty = !p.dirty;
    rl_provenance_environment(&q, other);
    assert_string_equal(base, other);
    rl_provenance_fill(&q, 2, "osmesa", "llvmpipe", "4.5"); /* asked again */
    rl_provenance_environment(&q, other);
    assert_string_equal(base, other);

    char *const field[] = {q.version, q.code_hash, q.compiler, q.cflags,    q.cpu,
                           q.os,      q.backend,   q.renderer, q.gl_version};
    for (size_t i = 0; i < sizeof field / sizeof field[0]; i++) {
        char kept = field[i][0];
        field[i][0] = '#';
        rl_provenance_environment(&q, other);
        assert_string_not_equal(base, other);
        field[i][0] = kept;
    }
    q.threads = 1;
    rl_provenance_environment(&q, other);
    assert_string_not_equal(base, other);
}

/* What a reference image depends on of all this: the program, not where it runs. */
static void test_program(void **state)
{
    (void)state;
    struct rl_provenance p;
    char base[RL_HASH_TEXT], other[RL_HASH_TEXT];
    rl_provenance_fill(&p, 2, "osmesa", "llvmpipe", "4.5");
    rl_provenance_program(&p, base);
    char *const same[] = {p.commit, p.cpu, p.os, p.backend, p.renderer, p.gl_version, p.time};
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++)
        same[i][0] = '#';
    p.dirty = !p.dirty;
    p.threads = 1;
    rl_provenance_program(&p, other);
    assert_string_equal(base, other);
    char *const field[] = {p.version, p.code_hash, p.compiler, p.cflags};
    for (size_t i = 0; i < sizeof field / sizeof field[0]; i++) {
        char kept = field[i][0];
        field[i][0] = '#';
        rl_provenance_program(&p, other);
        assert_string_not_equal(base, other);
        field[i][0] = kept;
    }
}

static void test_machine(void **state)
{
    (void)state;
    struct rl_provenance p;
    rl_provenance_fill(&p, 0, "osmesa", "llvmpipe", "4.5");
    assert_true(p.threads >= 1);
    assert_true(strlen(p.cpu) > 0 && strlen(p.os) > 0 && strlen(p.compiler) > 0);
    assert_int_equal(strlen(p.time), strlen("2026-01-31T12:00:00Z"));
    assert_string_not_equal(p.code_hash, "cbf29ce484222325"); /* the hash of nothing */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_environment), cmocka_unit_test(test_program),
                                       cmocka_unit_test(test_machine)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
