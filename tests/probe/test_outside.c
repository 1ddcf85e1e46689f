/* An effect from outside: its two files and its row in the table are all that scene files, plans, both renderers, probes and studies need of
 * it. This program is linked with a table that has one row more than src/effects/table.c, and reads shaders from a folder that has one file
 * more than shaders/effects. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/files.h"
#include "base/paths.h"
#include "gpu/against_cpu.h"
#include "probe/probe.h"
#include "studies/features.h"
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

extern const struct rl_effect rl_effect_minnaert;

const struct rl_effect rl_effect_minnaert = {
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

/* ---- What would be X(minnaert) in src/effects/table.c ---- */

/* The table's own text under other names, for its list of rows. The program's archive has the table under the right ones, but is asked only for
 * what is not defined yet. */
#define rl_effects rl_effects_inside
#define rl_n_effects rl_n_effects_inside
#include "effects/table.c" /* NOLINT(bugprone-suspicious-include) */
#undef rl_effects
#undef rl_n_effects

const struct rl_effect *const rl_effects[] = {EFFECTS(ROW) ROW(minnaert)};
const size_t rl_n_effects = sizeof rl_effects / sizeof rl_effects[0];

/* ---- The folder ---- */

static struct temporary folder;
static struct rl_gpu *gpu;

/* Links every file of shaders/NAME. */
static void link_all(const char *name)
{
    char relative[128], from[PATH_MAX], here[PATH_MAX], to[PATH_MAX];
    struct rl_error error;
    snprintf(relative, sizeof relative, "shaders/%s", name);
    temporary_path(&folder, to, relative);
    check_ok(rl_directory_create(to, &error), &error);
    assert_non_null(getcwd(here, sizeof here));
    DIR *list = opendir(relative);
    assert_non_null(list);
    for (struct dirent *entry; (entry = readdir(list));) {
        if (!strstr(entry->d_name, ".glsl"))
            continue;
        snprintf(relative, sizeof relative, "shaders/%s/%.80s", name, entry->d_name);
        assert_in_range(snprintf(from, sizeof from, "%.3900s/%s", here, relative), 1, PATH_MAX - 1);
        temporary_path(&folder, to, relative);
        assert_int_equal(symlink(from, to), 0);
    }
    closedir(list);
}

static int set_up(void **state)
{
    (void)state;
    static const char *const folders[] = {"common", "effects", "methods", "passes"};
    struct rl_error error;
    char path[PATH_MAX];
    temporary_make(&folder);
    temporary_path(&folder, path, "shaders");
    check_ok(rl_directory_create(path, &error), &error);
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++)
        link_all(folders[i]);
    temporary_path(&folder, path, "shaders/effects/minnaert.glsl");
    check_ok(rl_file_write(path, glsl, sizeof glsl - 1, &error), &error);
    check_ok(setenv("ROUGHLIGHT_DATA", folder.folder, 1), &error);
    return rl_gpu_open(&gpu, "auto", &error);
}

static int tear_down(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    temporary_remove(&folder);
    return 0;
}

static void test_probe(void **state)
{
    (void)state;
    enum { ROWS = 1000, IN = 13 };
    struct rl_error error;
    struct rl_probe probe;
    static double rows[ROWS][IN], cpu[ROWS][3], shader[ROWS][3];
    check_ok(rl_probe_find(&probe, "minnaert", &error), &error);
    assert_false(rl_probe_of_effect(&(struct rl_probe){0}, &rl_effect_minnaert, true));
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
    check_ok(rl_probe_gpu(&probe, gpu, rows[0], ROWS, shader[0], &error), &error);
    double most = 0.0;
    for (int i = 0; i < ROWS; i++)
        for (int c = 0; c < 3; c++) {
            check_near(shader[i][c], cpu[i][c], rl_effect_minnaert.absolute);
            most = fmax(most, cpu[i][c]);
        }
    assert_true(most > 0.5);
}

/* ---- Scenes ---- */

static const char scene_text[] = "film: {width: 160, height: 120}\n"
                                 "camera: {position: [0, 1, 4], target: [0, 0, 0], field-of-view: 34}\n"
                                 "materials:\n"
                                 "  - name: moon\n"
                                 "%s\n"
                                 "objects:\n"
                                 "  - {name: moon, shape: sphere, material: moon}\n"
                                 "lights:\n"
                                 "  - polygon: [[-3, 2, 1], [-1, 3, 1], [-1, 3, 3], [-3, 2, 3]]\n"
                                 "    radiance: [2, 1.8, 1.5]\n"
                                 "  - {position: [2, 2, 2], intensity: [5, 4, 4]}\n";

static int load(struct rl_scene *scene, const char *material, struct rl_error *error)
{
    char path[PATH_MAX], text[2048];
    int n = snprintf(text, sizeof text, scene_text, material);
    temporary_path(&folder, path, "scene.yaml");
    check_ok(rl_file_write(path, text, (size_t)n, error), error);
    return rl_scene_load(scene, path, error);
}

static void test_scene_file(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    check_ok(load(&scene, "    minnaert: {albedo: [0.5, 0.6, 0.7], darkening: 2}", &error), &error);
    const double *value = rl_effect_given(&scene.material[0], &rl_effect_minnaert);
    assert_non_null(value);
    check_near(value[1], 0.6, 0.0);
    check_near(value[3], 2.0, 0.0);
    rl_scene_clear(&scene);
    static const struct {
        const char *material, *message;
    } wrong[] = {
        {"    minnaert: {darkening: 2}", "materials[0].minnaert.albedo: found nothing, expected k"},
        {"    minnaert: {albedo: [0.5, 0.6, 1.7]}",
         "materials[0].minnaert.albedo[2]: found '1.7', expected 0 to 1"},
        {"    minnaert: {albedo: [0.5, 0.6, 0.7], darkening: 4}",
         "materials[0].minnaert.darkening: found '4', expected 1 to 3"},
        {"    minnaert: {gloss: 4}", "found the unknown key 'gloss', expected albedo or darkening"},
        {"    minnaert: {albedo: [0.5, 0.6, 0.7]}\n    diffuse: [1, 1, 1]",
         "found diffuse and minnaert, expected one model of diffuse"},
        {"    minaert: {albedo: [0.5, 0.6, 0.7]}", "minnaert"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        check_fails(load(&scene, wrong[i].material, &error), &error, RL_ERR_INPUT, wrong[i].message);
}

/* Planned where it does something, with its module and those of the lights that it sees; else dropped with the reason. */
static void test_plan(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_plan_program program = {0};
    check_ok(load(&scene, "    minnaert: {albedo: [0.5, 0.6, 0.7]}", &error), &error);
    check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
    assert_int_equal(plan.material[0].n_effects, 1);
    assert_ptr_equal(plan.material[0].effect[0], &rl_effect_minnaert);
    assert_int_equal(plan.sees, RL_SEES_SOURCES | RL_SEES_CENTROIDS);
    assert_int_equal(plan.n_programs, 1);
    rl_plan_add_effect(&program, &rl_effect_minnaert,
                       rl_effect_given(&scene.material[0], &rl_effect_minnaert));
    assert_int_equal(program.n_modules, 1);
    assert_string_equal(program.module[0], "effects/minnaert");
    bool linked = false;
    for (size_t i = 0; i < plan.program[0].n_modules; i++)
        linked = linked || strcmp(plan.program[0].module[i], program.module[0]) == 0;
    assert_true(linked);
    rl_plan_clear(&plan);
    rl_scene_clear(&scene);

    check_ok(load(&scene, "    minnaert: {albedo: [0, 0, 0]}", &error), &error);
    check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
    assert_int_equal(plan.material[0].n_effects, 0);
    bool said = false;
    for (size_t i = 0; i < plan.n_drops; i++)
        said =
            said || (strcmp(plan.drop[i].kind, "effect") == 0 && strcmp(plan.drop[i].name, "minnaert") == 0 &&
                     strstr(plan.drop[i].reason, "its coefficients are 0"));
    assert_true(said);
    rl_plan_clear(&plan);
    rl_scene_clear(&scene);
}

/* On the GPU as on the CPU, alone and beside others. */
static void test_pictures(void **state)
{
    (void)state;
    static const char *const materials[] = {
        "    minnaert: {albedo: [0.5, 0.6, 0.7], darkening: 2.5}",
        "    ambient: [0.1, 0.1, 0.1]\n    minnaert: {albedo: [0.5, 0.6, 0.7]}\n"
        "    phong: {specular: [0.3, 0.3, 0.3], exponent: 20}\n    rr: 5\n    highlight: plain",
    };
    for (size_t i = 0; i < sizeof materials / sizeof materials[0]; i++) {
        struct rl_error error;
        struct rl_scene scene;
        check_ok(load(&scene, materials[i], &error), &error);
        check_against_cpu("minnaert", gpu, &scene, 10);
        rl_scene_clear(&scene);
    }
}

/* What the study of effects measures. */
static void test_feature(void **state)
{
    (void)state;
    struct rl_feature feature[RL_FEATURES_MAX];
    struct rl_material material = {0};
    size_t n = rl_features_list(feature), found = 0;
    for (size_t i = 0; i < n; i++)
        found += feature[i].effect == &rl_effect_minnaert;
    assert_int_equal(found, 1);
    rl_feature_give(&material, &rl_effect_minnaert);
    const double *value = rl_effect_given(&material, &rl_effect_minnaert);
    assert_true(value[0] == 0.5 && value[3] == 1.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_probe),    cmocka_unit_test(test_scene_file), cmocka_unit_test(test_plan),
        cmocka_unit_test(test_pictures), cmocka_unit_test(test_feature),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
