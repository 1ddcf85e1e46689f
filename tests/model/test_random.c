/* Random numbers by address: the mixer against its published sequence, and whether numbers are uniform and
 * independent along the index, across neighbouring seeds and in pairs. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <gsl/gsl_cdf.h>

#include <cmocka.h>

#include "model/random.h"
#include "support/check.h"

/* The first outputs of SplitMix64 from the state 1234567, as its public-domain C code (Vigna 2015) gives them. */
static void test_mixer(void **state)
{
    (void)state;
    static const uint64_t expected[] = {UINT64_C(6457827717110365317), UINT64_C(3203168211198807973),
                                        UINT64_C(9817491932198370423), UINT64_C(4593380528125082431),
                                        UINT64_C(16408922859458223821)};
    uint64_t x = 1234567;
    for (int i = 0; i < 5; i++) {
        x += UINT64_C(0x9e3779b97f4a7c15);
        assert_true(rl_random_mix(x) == expected[i]);
    }
}

/* The probability of so uneven a table or a more uneven one, were all cells alike. */
static double uniform_p(const int counts[], int cells, int total)
{
    double chi2 = 0.0;
    double expected = (double)total / cells;
    for (int i = 0; i < cells; i++)
        chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
    return gsl_cdf_chisq_Q(chi2, cells - 1);
}

enum { CELLS = 32, DRAWS = 1 << 18 };

static void add_pair(int counts[], double a, double b)
{
    size_t row = (size_t)(a * CELLS);
    size_t column = (size_t)(b * CELLS);
    counts[row * CELLS + column]++;
}

static void test_uniform_and_independent(void **state)
{
    (void)state;
    static const uint64_t seeds[] = {0, 1, 2, 12345, UINT64_MAX};
    for (size_t s = 0; s < sizeof seeds / sizeof seeds[0]; s++) {
        uint64_t seed = seeds[s];
        static int successive[CELLS * CELLS], neighbouring[CELLS * CELLS], rows[CELLS * CELLS];
        for (int i = 0; i < CELLS * CELLS; i++)
            successive[i] = neighbouring[i] = rows[i] = 0;
        double sum = 0.0;
        for (uint64_t i = 0; i < DRAWS; i++) {
            double u = rl_random_uniform(seed, 2 * i);
            assert_true(u > 0.0 && u < 1.0);
            sum += u;
            add_pair(successive, u, rl_random_uniform(seed, 2 * i + 1));
            add_pair(neighbouring, u, rl_random_uniform(seed + 1, 2 * i));
            add_pair(rows, u, rl_random_uniform(seed, 2 * i + 256));
        }
        /* Mean 1/2, variance 1/12. */
        check_near(sum / DRAWS, 0.5, 4.5 * sqrt(1.0 / 12.0 / DRAWS));
        /* 15 tests: one in a thousand somewhere. */
        assert_true(uniform_p(successive, CELLS * CELLS, DRAWS) > 1e-4);
        assert_true(uniform_p(neighbouring, CELLS * CELLS, DRAWS) > 1e-4);
        assert_true(uniform_p(rows, CELLS * CELLS, DRAWS) > 1e-4);
    }
}

static int compare(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a;
    uint64_t y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Seed s + 1 is not seed s shifted: no number comes twice among neighbouring seeds. */
static void test_seeds_do_not_overlap(void **state)
{
    (void)state;
    enum { SEEDS = 64, EACH = 1024 };
    static uint64_t drawn[SEEDS * EACH];
    for (uint64_t s = 0; s < SEEDS; s++)
        for (uint64_t i = 0; i < EACH; i++)
            drawn[s * EACH + i] = rl_random_bits(s, i);
    qsort(drawn, sizeof drawn / sizeof drawn[0], sizeof drawn[0], compare);
    for (int i = 1; i < SEEDS * EACH; i++)
        assert_true(drawn[i] != drawn[i - 1]);
}

static void test_same_address_same_number(void **state)
{
    (void)state;
    assert_true(rl_random_uniform(9, 8) == rl_random_uniform(9, 8));
    assert_true(rl_random_bits(9, 8) != rl_random_bits(8, 9));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_mixer),
        cmocka_unit_test(test_uniform_and_independent),
        cmocka_unit_test(test_seeds_do_not_overlap),
        cmocka_unit_test(test_same_address_same_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
