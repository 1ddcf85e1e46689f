/* An effect from outside: its two files, and no more, are what probes, parity and plans need of it. A third one, the row in the table, is what
 * makes scene files know it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/files.h"
#include "base/paths.h"
#include "probe/probe.h"
#include "support/check.h"
#include "support/temporary.h"

/* ---- What would be src/effects/minnaert.c ---- */

/* Minnaert 1941: k (N.L)^m (N.V)^(m - 1), here with m from 1 on. */
static void pack(const double *value, double params[][4])
{
    memcpy(params[0], value, 4 * sizeof *value);
}

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    double n_l = fmax(0.0, v3_dot(s->N, L)), n_v = fmax(0.0, v3_dot(s->N, s->V));
    for (int c = 0; c < 3; c++)
        rgb[c] = params[0][c] * n_l * pow(n_l * n_v, params[0][3] - 1.0);
}

static const struct rl_effect_param param[] = {
    {.key = "albedo",
     .help = "k",
     .kind = RL_EFFECT_COLOUR,
     .high = 1.0,
     .required = true,
     .coefficient = true},
    {.key = "darkening", .help = "m (1.5)", .low = 1.0, .high = 3.0, .absent = {1.5}},
    {0},
};

static const struct rl_effect minnaert = {
    .name = "minnaert",
    .summary = "darkening towards the limb",
    .sees = RL_SEES_SOURCES | RL_SEES_CENTROIDS,
    .roles = RL_ROLE_DIFFUSE,
    .param = param,
    .n_params = 1,
    .pack = pack,
    .reflect = reflect,
    .absolute = 1e-5,
};

/* ---- What would be shaders/effects/minnaert.glsl ---- */

static const char glsl[] = "vec3 reflect_minnaert(Surface s, vec3 L, vec4 params[1])\n"
                           "{\n"
                           "    float n_l = max(0.0, dot(s.N, L));\n"
                           "    float x = n_l * max(0.0, dot(s.N, s.V));\n"
                           "    return params[0].rgb * (x > 0.0 ? n_l * pow(x, params[0].w - 1.0) : "
                           "params[0].w > 1.0 ? 0.0 : n_l);\n"
                           "}\n";

static struct temporary folder;

static void copy(const char *module)
{
    struct rl_error error;
    char from[128], to[PATH_MAX], *text;
    size_t size;
    snprintf(from, sizeof from, "shaders/%s.glsl", module);
    check_ok(rl_file_read(&text, &size, from, &error), &error);
    temporary_path(&folder, to, from);
    check_ok(rl_file_write(to, text, size, &error), &error);
    free(text);
}

static int set_up(void **state)
{
    (void)state;
    static const char *const folders[] = {"shaders", "shaders/common", "shaders/effects", "shaders/passes"};
    struct rl_error error;
    char path[PATH_MAX];
    temporary_make(&folder);
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++) {
        temporary_path(&folder, path, folders[i]);
        check_ok(rl_directory_create(path, &error), &error);
    }
    copy("common/surface");
    copy("passes/probe");
    temporary_path(&folder, path, "shaders/effects/minnaert.glsl");
    check_ok(rl_file_write(path, glsl, sizeof glsl - 1, &error), &error);
    return setenv("ROUGHLIGHT_DATA", folder.folder, 1);
}

static int tear_down(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

static void test_probe(void **state)
{
    (void)state;
    enum { ROWS = 1000, IN = 13 };
    struct rl_error error;
    struct rl_probe probe;
    struct rl_gpu *gpu;
    static double rows[ROWS][IN], cpu[ROWS][3], shader[ROWS][3];
    assert_true(rl_probe_of_effect(&probe, &minnaert, false));
    assert_false(rl_probe_of_effect(&(struct rl_probe){0}, &minnaert, true));
    assert_int_equal(probe.n_in, IN);
    assert_string_equal(probe.in[9].name, "albedo_r");
    assert_string_equal(probe.in[12].name, "darkening");
    for (int i = 0; i < ROWS; i++) {
        double t = 0.01 * i;
        const double row[IN] = {0.1, 0.2, 1.0, cos(3.0 * t),        0.5, 0.8, sin(5.0 * t), 0.3, cos(t),
                                0.5, 0.8, 1.0, 1.0 + 2.0 * i / ROWS};
        for (int k = 0; k < IN; k++)
            rows[i][k] = (double)(float)row[k];
        check_ok(rl_probe_check_row(&probe, rows[i], &error), &error);
    }
    rl_probe_cpu(&probe, rows[0], ROWS, cpu[0]);
    check_ok(rl_gpu_open(&gpu, "auto", &error), &error);
    check_ok(rl_probe_gpu(&probe, gpu, rows[0], ROWS, shader[0], &error), &error);
    rl_gpu_close(gpu);
    double most = 0.0;
    for (int i = 0; i < ROWS; i++)
        for (int c = 0; c < 3; c++) {
            check_near(shader[i][c], cpu[i][c], minnaert.absolute);
            most = fmax(most, cpu[i][c]);
        }
    assert_true(most > 0.5);
}

static void test_plan(void **state)
{
    (void)state;
    struct rl_plan_program program = {0};
    const double value[4] = {1.0, 1.0, 1.0, 1.5};
    rl_plan_add_effect(&program, &minnaert, value);
    assert_int_equal(program.n_modules, 1);
    assert_string_equal(program.module[0], "effects/minnaert");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_probe),
        cmocka_unit_test(test_plan),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
