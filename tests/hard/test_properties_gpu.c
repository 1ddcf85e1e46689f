/* Every function that a shader has, on a hundred thousand rows spread over the exponents of single precision: finite, in range where the C function
 * is, and no farther from it than its descriptor states. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>

#include "hard/draw_row.h"
#include "hard/property.h"
#include "probe/rounding.h"
#include "support/check.h"

enum { ROWS = 100000, SHOWN = 2 };
static uint64_t seed = 20261129; /* or $HARD_SEED */

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

/* What is no vector, but for what a listing subtracts and the luminance of colours that have parts below 0. */
static bool never_negative(const struct rl_probe *p)
{
    if (strcmp(p->name, "luminance") == 0)
        return false;
    return (p->effect && strcmp(p->name, "goldman-printed") != 0) || p->n_out == 1;
}

/* Shaders may take what is smaller for 0, as GLSL has it: then they need not be near the C function, but finite. */
static bool has_tiny(const struct rl_probe *p, const double *row)
{
    for (size_t i = 3 * p->n_vectors; i < p->n_in; i++)
        if (row[i] != 0.0 && fabs(row[i]) < 1e-30)
            return true;
    return false;
}

/* Where arguments in single precision say little of the result: a half vector of nearly opposite directions, and an index of refraction near 1,
 * made from a reflectance: n - 1 is all that counts then, and n is rounded. */
static bool is_undecided(const struct rl_probe *p, const double *row)
{
    if (!p->effect || p->polygon)
        return false;
    rl_vec3 V = v3_normalize(v3(row[3], row[4], row[5])), L = v3_normalize(v3(row[6], row[7], row[8]));
    if (p->effect->reflect && p->effect->roles == RL_ROLE_SPECULAR && v3_length(v3_add(V, L)) < 0.02)
        return true;
    for (size_t i = 9; i < p->n_in; i++)
        if (strncmp(p->in[i].name, "reflectance", 11) == 0 && row[i] > 0.0 && row[i] < 1e-6)
            return true;
    return false;
}

/* Of one function. */
struct found {
    size_t not_finite, out_of_range, too_far;
    double worst; /* of what is allowed */
};

static void show(const struct rl_probe *p, const char *what, size_t k, const double *row, const double *cpu,
                 const double *shader)
{
    print_error("%s, %s %s: %.9g in GLSL, %.9g in C, at", p->name, p->out[k], what, shader[k], cpu[k]);
    for (size_t i = 0; i < p->n_in; i++)
        print_error(" %.9g", row[i]);
    print_error("\n");
}

static void compare(struct found *found, const struct rl_probe *p, const double *row, const double *cpu,
                    const double *shader)
{
    bool free = has_tiny(p, row) || is_undecided(p, row) || in_plane_by_rounding(p, row);
    for (size_t k = 0; k < p->n_out; k++) {
        double off = fabs(shader[k] - cpu[k]), allowed = p->absolute + p->relative * fabs(cpu[k]);
        double rounding[RL_PROBE_OUT_MAX] = {0.0};
        if (!isfinite(shader[k]) || !isfinite(cpu[k])) {
            if (found->not_finite++ < SHOWN)
                show(p, "is not finite", k, row, cpu, shader);
            continue;
        }
        if (never_negative(p) && shader[k] < 0.0 && found->out_of_range++ < SHOWN)
            show(p, "is negative", k, row, cpu, shader);
        if (free)
            continue;
        if (off > allowed)
            rounding_add(p, row, cpu, rounding);
        /* It is a sum of first differences, of arguments as they come; here functions are as steep as they get, and of rounded parameters. */
        allowed += 4.0 * rounding[k];
        found->worst = fmax(found->worst, off / allowed);
        if (!(off <= allowed) && found->too_far++ < SHOWN) {
            show(p, "is too far off", k, row, cpu, shader);
            print_error("  %.3g, expected at most %.3g\n", off, allowed);
        }
    }
}

static struct found check_function(const struct rl_probe *p, size_t stream)
{
    struct rl_error error;
    struct draw d = {.seed = seed, .index = (uint64_t)stream << 40, .single = true};
    struct found found = {0, 0, 0, 0.0};
    double *rows = malloc(ROWS * p->n_in * sizeof *rows), *cpu = malloc(ROWS * p->n_out * sizeof *cpu),
           *shader = malloc(ROWS * p->n_out * sizeof *shader);
    assert_true(rows && cpu && shader);
    for (size_t i = 0; i < ROWS; i++) {
        draw_row(&d, p, rows + i * p->n_in);
        check_ok(i % 100 == 0 ? rl_probe_check_row(p, rows + i * p->n_in, &error) : RL_OK, &error);
    }
    rl_probe_cpu(p, rows, ROWS, cpu);
    check_ok(rl_probe_gpu(p, gpu, rows, ROWS, shader, &error), &error);
    for (size_t i = 0; i < ROWS; i++)
        compare(&found, p, rows + i * p->n_in, cpu + i * p->n_out, shader + i * p->n_out);
    free(rows);
    free(cpu);
    free(shader);
    print_message("%-24s %zu not finite, %zu negative, %zu too far; farthest: %.2g of what is allowed\n",
                  p->name, found.not_finite, found.out_of_range, found.too_far, found.worst);
    return found;
}

static void test_shaders(void **state)
{
    (void)state;
    struct rl_probe p;
    size_t tested = 0, bad = 0;
    const char *other = getenv("HARD_SEED");
    seed = other ? strtoull(other, NULL, 10) : seed;
    print_message("seed %llu\n", (unsigned long long)seed);
    for (size_t k = 0; rl_probe_at(&p, k); k++) {
        if (rl_probe_check_gpu(&p, NULL) != RL_OK)
            continue;
        struct found found = check_function(&p, k);
        bad += found.not_finite + found.out_of_range + found.too_far;
        tested++;
    }
    assert_true(tested > rl_n_effects);
    assert_int_equal(bad, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_shaders)};
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
