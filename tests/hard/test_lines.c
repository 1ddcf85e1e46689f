/* The reference on the catalogue of hard lights (tests/hard/lights/lights.tsv): on every instruction set that this machine has, asked for 1e-12,
 *
 *     |value - exact| <= its stated error + the greater of 8 units in the last place and twice `moved`,
 *
 * `moved` being what the inputs' own rounding moves the exact answer by; and the stated error is no more than the tolerance and 32 ulp of
 * a direction, such as V itself has of rounding, can make of a line's U at the lobe's peak, D(0). The witness `exhaustive` keeps within
 * its stated error. Prints the worst row of each.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "reference/integrators.h"
#include "support/check.h"

enum { COLUMNS = 11, LIGHTS = 2, CORNERS = 4 };
static const char path[] = "tests/hard/lights/lights.tsv";

struct row {
    size_t line;
    char why[200];
    double rr, value, moved;
    bool attenuation;
    struct rl_surface surface;
    rl_vec3 corner[LIGHTS][CORNERS];
    size_t n_corners[LIGHTS], n_lights;
};

/* x,y,z x,y,z ... */
static size_t take_vectors(rl_vec3 out[], size_t most, const char *text)
{
    size_t n = 0;
    while (*text != '\0' && n < 3 * most) {
        char *end;
        double x = strtod(text, &end);
        if (end == text)
            break;
        *(n % 3 == 0 ? &out[n / 3].x : n % 3 == 1 ? &out[n / 3].y : &out[n / 3].z) = x;
        n++;
        text = end + strspn(end, ", ");
    }
    return n / 3;
}

static void take_row(struct row *row, char *field[COLUMNS])
{
    row->rr = strtod(field[0], NULL);
    row->attenuation = strcmp(field[1], "on") == 0;
    assert_int_equal(take_vectors(&row->surface.P, 1, field[2]), 1);
    assert_int_equal(take_vectors(&row->surface.N, 1, field[3]), 1);
    assert_int_equal(take_vectors(&row->surface.V, 1, field[4]), 1);
    row->surface.N = v3_normalize(row->surface.N);
    row->surface.V = v3_normalize(row->surface.V);
    for (row->n_lights = 0; row->n_lights < LIGHTS && strcmp(field[5 + row->n_lights], "-") != 0;
         row->n_lights++) {
        size_t i = row->n_lights;
        row->n_corners[i] = take_vectors(row->corner[i], CORNERS, field[5 + i]);
        assert_true(row->n_corners[i] >= 3);
    }
    row->value = strtod(field[7], NULL);
    row->moved = strtod(field[8], NULL);
    snprintf(row->why, sizeof row->why, "%s", field[10]);
}

/* The next row; false at the end. */
static bool next_row(struct row *row, FILE *from, char **line, size_t *room)
{
    while (getline(line, room, from) >= 0) {
        row->line++;
        (*line)[strcspn(*line, "\n")] = '\0';
        if ((*line)[0] == '#' || strncmp(*line, "rr\t", 3) == 0)
            continue;
        char *field[COLUMNS], *at = *line;
        for (int i = 0; i < COLUMNS; i++) {
            assert_non_null(at);
            field[i] = strsep(&at, "\t");
        }
        assert_null(at);
        take_row(row, field);
        return true;
    }
    return false;
}

static struct rl_light_set *lights_of(const struct row *row)
{
    const rl_vec3 *vertices[LIGHTS] = {row->corner[0], row->corner[1]};
    struct rl_light_set *set = NULL;
    struct rl_error error;
    check_ok(rl_light_set_from_polygons(&set, vertices, row->n_corners, row->n_lights, &error), &error);
    return set;
}

static double bound_of(const struct row *row, double stated)
{
    double ulp = row->value > 0.0 ? ldexp(1.0, ilogb(row->value) - 52) : 0.0;
    return stated + fmax(8.0 * ulp, 2.0 * row->moved);
}

/* What judging a row takes, and what is found. */
struct trial {
    const struct rl_integrator *integrator;
    struct rl_integrate_options options;
    bool adaptive; /* its stated error is held against the tolerance */
    size_t rows, failed, worst_line;
    double worst, greatest_error, greatest_stated; /* worst: the error as a part of its bound */
};

static void judge(struct trial *trial, const struct row *row)
{
    struct rl_light_set *set = lights_of(row);
    struct rl_ellipsoid e = rl_ellipsoid_make(row->rr);
    struct rl_estimate estimate;
    struct rl_error error;
    trial->options.attenuation = row->attenuation;
    check_ok(trial->integrator->integrate(&estimate, &row->surface, &e, set, &trial->options, &error),
             &error);
    rl_light_set_free(set);
    double off = fabs(estimate.value[0] - row->value), bound = bound_of(row, estimate.error[0]);
    double part = off > 0.0 ? off / bound : 0.0;
    trial->rows++;
    trial->greatest_stated = fmax(trial->greatest_stated, estimate.error[0]);
    if (row->moved < 1e-14)
        trial->greatest_error = fmax(trial->greatest_error, off);
    if (!(part <= trial->worst)) {
        trial->worst = part;
        trial->worst_line = row->line;
    }
    double most_stated = trial->adaptive ? trial->options.tolerance + 32.0 * DBL_EPSILON * e.norm : INFINITY;
    if (!(off <= bound && estimate.error[0] <= most_stated)) {
        trial->failed++;
        print_error("%s:%zu: %.17g, off by %.3g; stated error %.3g, bound %.3g: %s\n", path, row->line,
                    estimate.value[0], off, estimate.error[0], bound, row->why);
    }
}

static void judge_all(struct trial *trial, const char *name)
{
    FILE *from = fopen(path, "r");
    assert_non_null(from);
    struct row row = {.line = 0};
    char *line = NULL;
    size_t room = 0;
    while (next_row(&row, from, &line, &room))
        judge(trial, &row);
    free(line);
    fclose(from);
    print_message("%s: %zu rows, %zu failed; greatest error %.3g (inputs that move the answer by less than "
                  "1e-14), stated %.3g; worst "
                  "%.3g of its bound, line %zu\n",
                  name, trial->rows, trial->failed, trial->greatest_error, trial->greatest_stated,
                  trial->worst, trial->worst_line);
    assert_true(trial->rows > 100);
}

static void test_reference(void **state)
{
    (void)state;
    size_t failed = 0;
    for (int simd = 0; simd <= (int)rl_simd_best(); simd++) {
        struct trial trial = {
            .integrator = rl_integrator_find("reference"),
            .options = {.tolerance = 1e-12, .simd = (enum rl_simd)simd},
            .adaptive = true,
        };
        judge_all(&trial, rl_simd_name((enum rl_simd)simd));
        failed += trial.failed;
    }
    assert_int_equal(failed, 0);
}

static void test_exhaustive(void **state)
{
    (void)state;
    struct trial trial = {
        .integrator = rl_integrator_find("exhaustive"),
        .options = {.tolerance = 1e-3, .env_size = 64},
    };
    judge_all(&trial, "exhaustive");
    assert_int_equal(trial.failed, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_reference),
        cmocka_unit_test(test_exhaustive),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
