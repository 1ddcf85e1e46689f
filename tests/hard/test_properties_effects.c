/* Properties of every effect over a million random inputs, through its probe: finite, not negative, nothing from below the horizon, the same in a
 * mirror and for vectors of any length, and with light and eye exchanged where the model has it so. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "hard/draw.h"
#include "hard/draw_row.h"
#include "hard/property.h"
#include "model/pair.h"
#include "probe/probe.h"
#include "support/check.h"

enum { ROWS = 1000000 };
static const uint64_t seed = 20261128;

static rl_vec3 unit(const double *in)
{
    return v3_normalize(v3(in[0], in[1], in[2]));
}

/* How much of the value must stay where light and eye are exchanged: value x cosine of the side it is radiance of. */
enum exchange { NO_EXCHANGE, AS_IT_IS, TIMES_COSINE };

static enum exchange exchange_of(const struct rl_probe *p)
{
    if (strcmp(p->name, "blinn") == 0)
        return AS_IT_IS;
    return strcmp(p->name, "cook-torrance") == 0 ? TIMES_COSINE : NO_EXCHANGE;
}

static void check_range(const struct rl_probe *p, const double *in, const double *out)
{
    /* Lambert's term unclamped takes light away: what the listing has. */
    bool printed = strcmp(p->name, "goldman-printed") == 0;
    for (int c = 0; c < 3; c++) {
        require(isfinite(out[c]), in, p->n_in);
        require(out[c] >= 0.0 || printed, in, p->n_in);
    }
    if (p->effect->factor)
        require(out[0] <= 1.0 && out[1] <= 1.0 && out[2] <= 1.0, in, p->n_in);
    double n_l = p->polygon || !p->effect->reflect ? 1.0 : v3_dot(unit(in), unit(in + 6));
    if (!p->effect->below && n_l <= 0.0)
        require(out[0] == 0.0 && out[1] == 0.0 && out[2] == 0.0, in, p->n_in);
}

static bool same(const double a[3], const double b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Every vector mirrored at x = 0, and every one halved: to the bit. */
static void check_mirror(const struct rl_probe *p, const double *in, const double *out)
{
    double mirrored[RL_PROBE_IN_MAX], halved[RL_PROBE_IN_MAX], there[RL_PROBE_OUT_MAX];
    memcpy(mirrored, in, p->n_in * sizeof *in);
    memcpy(halved, in, p->n_in * sizeof *in);
    bool whole = true;
    for (size_t i = 0; i < 3 * p->n_vectors; i++) {
        mirrored[i] *= i % 3 == 0 ? -1.0 : 1.0;
        halved[i] *= 0.5;
        /* Half of a number that has lost digits already is not half of it. */
        bool large = p->polygon ? fabs(in[i]) > 1e-75 && fabs(in[i]) < 1e75 : fabs(in[i]) > 1e-300;
        whole = whole && (in[i] == 0.0 || large);
    }
    rl_probe_cpu(p, mirrored, 1, there);
    require(same(there, out), in, p->n_in);
    if (!whole)
        return;
    /* Of a corner of 1e-79 of a light the edges' squares leave the range of numbers, at one size before the other. */
    if (p->polygon && fmax(out[0], fmax(out[1], out[2])) < 1e-120)
        return;
    rl_probe_cpu(p, halved, 1, there);
    require(same(there, out), in, p->n_in);
}

static void check_exchange(const struct rl_probe *p, const double *in, const double *out)
{
    enum exchange exchange = exchange_of(p);
    if (exchange == NO_EXCHANGE)
        return;
    double other[RL_PROBE_IN_MAX], there[RL_PROBE_OUT_MAX];
    memcpy(other, in, p->n_in * sizeof *in);
    for (int c = 0; c < 3; c++) {
        other[3 + c] = in[6 + c];
        other[6 + c] = in[3 + c];
    }
    rl_probe_cpu(p, other, 1, there);
    /* Plain sums would add a rounding of their own near the horizon. */
    struct rl_pair_vec3 N = rl_pair_vec3_of(unit(in));
    double n_v = rl_pair_cosine(N, rl_pair_vec3_of(unit(in + 3))).high;
    double n_l = rl_pair_cosine(N, rl_pair_vec3_of(unit(in + 6))).high;
    double here = exchange == AS_IT_IS ? 1.0 : n_v, that = exchange == AS_IT_IS ? 1.0 : n_l;
    for (int c = 0; c < 3; c++) {
        double a = out[c] * here, b = there[c] * that;
        require(fabs(a - b) <= 16.0 * ULP * fmax(a, b) + 1e-300, in, p->n_in);
    }
}

static void check_effect(const struct rl_probe *p, size_t stream)
{
    struct rl_error error;
    struct draw d = {.seed = seed, .index = (uint64_t)stream << 40};
    double in[RL_PROBE_IN_MAX], out[RL_PROBE_OUT_MAX], most = 0.0;
    for (int i = 0; i < ROWS; i++) {
        draw_row(&d, p, in);
        /* Every thousandth: that what is drawn is what is taken. */
        if (i % 1000 == 0)
            check_ok(rl_probe_check_row(p, in, &error), &error);
        rl_probe_cpu(p, in, 1, out);
        check_range(p, in, out);
        if (i % 4 == 0) {
            check_mirror(p, in, out);
            check_exchange(p, in, out);
        }
        most = fmax(most, out[0]);
    }
    print_message("%-24s to %.3g\n", p->name, most);
    assert_true(most > 0.0);
}

static void test_effects(void **state)
{
    (void)state;
    struct rl_probe p;
    size_t tested = 0;
    print_message("seed %llu\n", (unsigned long long)seed);
    for (size_t k = 0; rl_probe_at(&p, k); k++) {
        if (!p.effect)
            continue;
        check_effect(&p, k);
        tested++;
    }
    assert_true(tested >= rl_n_effects);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_effects)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
