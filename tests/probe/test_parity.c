/* Every function that a shader has: GLSL against C, on random and hard arguments, within the bound its descriptor states. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "model/random.h"
#include "probe/probe.h"
#include "probe/rounding.h"
#include "support/check.h"

enum { RANDOM_ROWS = 10000, HARD_ROWS = 4000, ROWS = RANDOM_ROWS + HARD_ROWS };
static const uint64_t seed = 20240607;

static struct rl_gpu *gpu;

static int open_gpu(void **state)
{
    (void)state;
    struct rl_error error;
    return rl_gpu_open(&gpu, "auto", &error);
}

static int close_gpu(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    return 0;
}

static double uniform(uint64_t *index)
{
    return rl_random_uniform(seed, (*index)++);
}

/* Single precision holds the arguments: what it loses of them is not the function's fault. */
static double single(double x)
{
    return (double)(float)x;
}

static void random_direction(double to[3], uint64_t *index)
{
    double z = 2.0 * uniform(index) - 1.0, azimuth = 2.0 * RL_PI * uniform(index);
    double r = sqrt(fmax(0.0, 1.0 - z * z));
    to[0] = r * cos(azimuth);
    to[1] = r * sin(azimuth);
    to[2] = z;
}

/* Along an axis, in a plane of two, a little off one of these, or the direction before it, turned round or nearly so. */
static void hard_direction(double to[3], const double *before, uint64_t *index)
{
    static const double off[] = {0.0, 0.0, 1e-7, 1e-5, 1e-3, -1e-3, 0.1};
    for (int c = 0; c < 3; c++)
        to[c] = floor(3.0 * uniform(index)) - 1.0;
    if (to[0] == 0.0 && to[1] == 0.0 && to[2] == 0.0)
        to[2] = 1.0;
    if (before && uniform(index) < 0.4) {
        double sign = uniform(index) < 0.5 ? 1.0 : -1.0;
        for (int c = 0; c < 3; c++)
            to[c] = sign * before[c];
    }
    for (int c = 0; c < 3; c++)
        to[c] += off[(int)(7.0 * uniform(index))];
    if (to[0] == 0.0 && to[1] == 0.0 && to[2] == 0.0)
        to[2] = 1.0;
}

static double random_value(const struct rl_probe_column *c, uint64_t *index)
{
    double u = uniform(index);
    if (c->whole)
        return floor(u * (c->high - c->low + 1.0)) + c->low;
    if (!(c->low < c->high))
        return 4.0 * u - 2.0;
    /* Wide ranges by their logarithm, else nothing small would ever come. */
    if (c->low > 0.0 && c->high > 100.0 * c->low)
        return c->low * pow(c->high / c->low, u);
    return c->low + (c->high - c->low) * u;
}

static double hard_value(const struct rl_probe_column *c, uint64_t *index)
{
    static const double values[] = {0.0, 1.0, -1.0, 0.5, 1e-6, -1e-6, 1e-3, 2.0};
    double u = uniform(index);
    if (c->whole)
        return random_value(c, index);
    if (u < 0.15 && c->low < c->high)
        return c->low;
    if (u < 0.3 && c->low < c->high)
        return c->high;
    double x = values[(int)(8.0 * uniform(index))];
    return c->low < c->high ? fmin(fmax(x, c->low), c->high) : x;
}

/* Parameters that may be left out are so half of the time, a colour's three together. */
static void leave_out(double *row, const struct rl_probe *p, uint64_t *index)
{
    bool out = false;
    for (size_t i = 0; i < p->n_in; i++) {
        size_t length = strlen(p->in[i].name);
        bool follows = length > 2 && (strcmp(p->in[i].name + length - 2, "_g") == 0 ||
                                      strcmp(p->in[i].name + length - 2, "_b") == 0);
        if (!follows)
            out = uniform(index) < 0.5;
        if (p->in[i].optional && out)
            row[i] = NAN;
    }
}

static void fill_row(double *row, const struct rl_probe *p, bool hard, uint64_t *index)
{
    size_t first = 3 * p->n_directions;
    for (size_t i = 0; i < p->n_directions; i++)
        if (hard)
            hard_direction(row + 3 * i, i ? row + 3 * (i - 1) : NULL, index);
        else
            random_direction(row + 3 * i, index);
    for (size_t i = first; i < p->n_in; i++)
        row[i] = hard ? hard_value(&p->in[i], index) : random_value(&p->in[i], index);
    for (size_t i = 0; i < p->n_in; i++) {
        row[i] = single(row[i]);
        /* Rounding may lead out of the range by one unit in the last place. */
        if (p->in[i].low < p->in[i].high && row[i] > p->in[i].high)
            row[i] = (double)nextafterf((float)row[i], -INFINITY);
        if (p->in[i].low < p->in[i].high && row[i] < p->in[i].low)
            row[i] = (double)nextafterf((float)row[i], INFINITY);
    }
    leave_out(row, p, index);
}

static void print_row(const struct rl_probe *p, const double *row)
{
    for (size_t i = 0; i < p->n_in; i++)
        print_error("%s%s %.9g", i ? ", " : "  at ", p->in[i].name, row[i]);
    print_error("\n");
}

/* Of the random rows: the greatest value, difference and relative difference (of values above 0.001); of all rows: the greatest
 * difference that rounding of the arguments does not explain. */
struct worst {
    double value, off, relative, own;
};

static void compare_row(struct worst *worst, const struct rl_probe *p, const double *row, const double *cpu,
                        const double *shader, bool hard)
{
    double rounding[RL_PROBE_OUT_MAX] = {0.0};
    if (in_plane_by_rounding(p, row))
        return;
    rounding_add(p, row, cpu, rounding);
    for (size_t k = 0; k < p->n_out; k++) {
        double off = fabs(shader[k] - cpu[k]), value = fabs(cpu[k]);
        double allowed = p->absolute + p->relative * value + rounding[k];
        worst->own = fmax(worst->own, off - rounding[k]);
        if (!hard) {
            worst->value = fmax(worst->value, value);
            worst->off = fmax(worst->off, off);
            worst->relative = fmax(worst->relative, value > 1e-3 ? off / value : 0.0);
        }
        if (off <= allowed)
            continue;
        print_error("%s: %s is %.9g in GLSL and %.9g in C, %.3g apart, expected at most %.3g\n", p->name,
                    p->out[k], shader[k], cpu[k], off, allowed);
        print_row(p, row);
        fail();
    }
}

static void compare(const struct rl_probe *p, const double *rows, const double *cpu, const double *shader)
{
    struct worst worst = {0.0, 0.0, 0.0, 0.0};
    for (size_t i = 0; i < ROWS; i++)
        compare_row(&worst, p, rows + i * p->n_in, cpu + i * p->n_out, shader + i * p->n_out,
                    i >= RANDOM_ROWS);
    print_message("%-24s random: value to %-8.3g error %-8.2g relative %-8.2g all, beyond rounding: %.2g\n",
                  p->name, worst.value, worst.off, worst.relative, worst.own);
}

static void test_parity(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_probe p;
    size_t tested = 0;
    print_message("seed %llu\n", (unsigned long long)seed);
    for (size_t k = 0; rl_probe_at(&p, k); k++) {
        struct rl_probe found; /* each by its own name, functions of the model and effects alike */
        check_ok(rl_probe_find(&found, p.name, &error), &error);
        assert_true(found.effect == p.effect && found.cpu == p.cpu);
        if (rl_probe_check_gpu(&p, NULL) != RL_OK)
            continue;
        double *rows = malloc(ROWS * p.n_in * sizeof *rows);
        double *cpu = malloc(ROWS * p.n_out * sizeof *cpu), *shader = malloc(ROWS * p.n_out * sizeof *shader);
        assert_true(rows && cpu && shader);
        /* By the name: a new probe leaves the others their rows. */
        uint64_t index = rl_hash_bytes(RL_HASH_START, p.name, strlen(p.name));
        for (size_t i = 0; i < ROWS; i++) {
            /* Combinations that an effect refuses are drawn again. */
            int status = RL_ERR_INPUT;
            for (int tries = 0; tries < 1000 && status != RL_OK; tries++) {
                fill_row(rows + i * p.n_in, &p, i >= RANDOM_ROWS, &index);
                status = rl_probe_check_row(&p, rows + i * p.n_in, &error);
            }
            check_ok(status, &error);
        }
        rl_probe_cpu(&p, rows, ROWS, cpu);
        check_ok(rl_probe_gpu(&p, gpu, rows, ROWS, shader, &error), &error);
        compare(&p, rows, cpu, shader);
        free(rows);
        free(cpu);
        free(shader);
        tested++;
    }
    assert_true(tested > 0);
}

/* A shader with a fault must not pass: B's columns in the frame's place of T's. */
static void test_faults_are_seen(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_probe p;
    check_ok(rl_probe_find(&p, "frame", &error), &error);
    p.glsl = "    mat3 f = tangent_frame(normalize(vec3(a[0], a[1], a[2])));\n"
             "    for (int i = 0; i < 6; i++)\n        r[i] = f[2 - i / 3][i % 3];\n";
    const double row[3] = {0.1, 0.2, 0.3};
    double cpu[6], shader[6];
    rl_probe_cpu(&p, row, 1, cpu);
    check_ok(rl_probe_gpu(&p, gpu, row, 1, shader, &error), &error);
    assert_true(fabs(cpu[0] - shader[0]) > 0.5);
    /* And one that does not compile names module and line. */
    p.glsl = "    r[0] = no_such_thing;\n";
    assert_int_equal(rl_probe_gpu(&p, gpu, row, 1, shader, &error), RL_ERR_INPUT);
    assert_non_null(strstr(error.message, "no_such_thing"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_parity),
        cmocka_unit_test(test_faults_are_seen),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
