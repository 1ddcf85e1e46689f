/* Whole pictures of a mesh that comes from a file, GPU against the CPU renderer: one for every effect of the table, and one for every highlight
 * method that runs on the GPU. What is added to the tables is tested here by itself. */
#include <unistd.h>

#include "base/files.h"
#include "gpu/against_cpu.h"
#include "gpu/fixture.h"
#include "scene/teapot.h"
#include "studies/features.h"
#include "support/temporary.h"

#define DUCK "/usr/share/assimp/models/PLY/Wuson.ply"

/* Pixels at outlines, where the rasteriser decides to 1/256 of a pixel. */
enum { OUTLIERS = 10 };

static struct rl_gpu *gpu;
static struct temporary folder;
static struct rl_feature feature[RL_FEATURES_MAX];
static size_t n_features;

/* Of a mesh within a box of size 2 about the origin, in light of all kinds. */
static const char scene_text[] =
    "film: {width: 160, height: 120}\n"
    "camera: {position: [1.2, 1.3, 3.2], target: [0, 0, 0], field-of-view: 26}\n"
    "materials:\n"
    "  - name: paint\n"
    "    rr: 10\n"
    "objects:\n"
    "  - {name: mesh, shape: mesh, file: %s, material: paint, scale: %.9g, translate: [%.9g, %.9g, %.9g]}\n"
    "lights:\n"
    "  - polygon: [[-3, 2, 1], [-1, 3, 1], [-1, 3, 3], [-3, 2, 3]]\n"
    "    radiance: [2, 1.8, 1.5]\n"
    "  - {position: [2, 2, 2], intensity: [5, 4, 4]}\n"
    "  - {direction: [0.5, -1, -0.5], irradiance: [0.5, 0.6, 0.7]}\n";

/* The teapot as a file that has triangles and no normals, as scans do. */
static void write_teapot(const char *path)
{
    struct rl_error error;
    struct rl_mesh mesh;
    check_ok(rl_teapot_build(&mesh, 8, &error), &error);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    for (size_t i = 0; i < mesh.n_vertices; i++)
        fprintf(out, "v %.9g %.9g %.9g\n", (double)mesh.position[i][0], (double)mesh.position[i][1],
                (double)mesh.position[i][2]);
    for (size_t i = 0; i < mesh.n_triangles; i++)
        fprintf(out, "f %u %u %u\n", mesh.triangle[i][0] + 1, mesh.triangle[i][1] + 1,
                mesh.triangle[i][2] + 1);
    assert_int_equal(fclose(out), 0);
    rl_mesh_clear(&mesh);
}

static int set_up(void **state)
{
    (void)state;
    struct rl_error error;
    char path[PATH_MAX];
    n_features = rl_features_list(feature);
    temporary_make(&folder);
    temporary_path(&folder, path, "teapot.obj");
    write_teapot(path);
    return rl_gpu_open(&gpu, "auto", &error);
}

static int tear_down(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    temporary_remove(&folder);
    return 0;
}

/* The scene with this mesh, scaled and moved. */
static void load_placed(struct rl_scene *scene, const char *file, double scale, rl_vec3 to)
{
    struct rl_error error;
    char path[PATH_MAX], text[2048];
    int n = snprintf(text, sizeof text, scene_text, file, scale, to.x, to.y, to.z);
    temporary_path(&folder, path, "scene.yaml");
    check_ok(rl_file_write(path, text, (size_t)n, &error), &error);
    check_ok(rl_scene_load(scene, path, &error), &error);
    scene->settings.method = NULL;
}

static void load(struct rl_scene *scene, const char *file)
{
    load_placed(scene, file, 1.0, v3(0.0, 0.0, 0.0));
    double scale = 1.0 / scene->object[0].radius;
    rl_vec3 to = v3_scale(-scale, scene->object[0].centre);
    rl_scene_clear(scene);
    load_placed(scene, file, scale, to);
}

static void check_effects(const char *file)
{
    struct rl_scene scene;
    load(&scene, file);
    assert_true(scene.object[0].mesh.n_triangles > 1000);
    for (size_t i = 0; i < n_features; i++) {
        struct rl_material *m = &scene.material[0];
        if (feature[i].kind != RL_FEATURE_EFFECT)
            continue;
        memset(m->effect, 0, sizeof m->effect);
        rl_feature_give(m, feature[i].effect);
        m->method = rl_feature_needs_highlight(&feature[i]) ? "plain" : NULL;
        check_against_cpu(feature[i].name, gpu, &scene, OUTLIERS);
    }
    rl_scene_clear(&scene);
}

static void test_effects(void **state)
{
    (void)state;
    check_effects("teapot.obj");
    if (access(DUCK, R_OK) == 0)
        check_effects(DUCK);
    else
        print_message("no %s here (Debian: assimp-testmodels)\n", DUCK);
}

/* Each kind of light alone: an effect brings what it needs for the lights that are there. */
static void test_lights(void **state)
{
    (void)state;
    struct rl_scene scene;
    load(&scene, "teapot.obj");
    assert_true(!scene.source[0].parallel && scene.source[1].parallel);
    const struct rl_scene all = scene;
    scene.width = 64;
    scene.height = 48;
    for (int kind = 0; kind < 4; kind++) {
        scene.n_lights = kind == 0;
        scene.n_sources = kind == 1 || kind == 2;
        scene.source = all.source + (kind == 2);
        for (size_t i = 0; i < n_features; i++) {
            struct rl_material *m = &scene.material[0];
            if (feature[i].kind != RL_FEATURE_EFFECT)
                continue;
            memset(m->effect, 0, sizeof m->effect);
            rl_feature_give(m, feature[i].effect);
            m->method = rl_feature_needs_highlight(&feature[i]) ? "plain" : NULL;
            check_against_cpu(feature[i].name, gpu, &scene, OUTLIERS);
        }
    }
    scene = all;
    rl_scene_clear(&scene);
}

static double rms_difference(const struct rl_image *a, const struct rl_image *b)
{
    double sum = 0.0;
    size_t foreground = 0;
    for (size_t i = 0; i < (size_t)a->width * (size_t)a->height; i++) {
        if (a->data[4 * i + 3] < 0.5f || b->data[4 * i + 3] < 0.5f)
            continue;
        foreground++;
        for (size_t c = 0; c < 3; c++)
            sum += pow((double)a->data[4 * i + c] - (double)b->data[4 * i + c], 2.0) / 3.0;
    }
    return sqrt(sum / (double)foreground);
}

/* A method that the CPU has too is the same to rounding. One that samples is an estimate of the integral seen from the mesh's centre: with
 * 256 normals within a hundredth of the light's radiance, of a highlight that is far more than that. */
static void test_methods(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_image truth, drawn, none;
    load(&scene, "teapot.obj");
    scene.settings.normal_bits = RL_NORMAL_BITS_FLOAT;
    scene.settings.env_size = 512;
    scene.settings.light_from = RL_LIGHT_FROM_OBJECT;
    scene.settings.tolerance = 1e-3;
    scene.material[0].method = "reference";
    render_cpu(&truth, &scene);
    scene.material[0].method = NULL;
    render_cpu(&none, &scene);
    assert_true(rms_difference(&none, &truth) > 0.05);
    for (size_t i = 0; i < n_features; i++) {
        if (feature[i].kind != RL_FEATURE_HIGHLIGHT)
            continue;
        scene.material[0].method = feature[i].name;
        if (feature[i].method->on_cpu) {
            check_against_cpu(feature[i].name, gpu, &scene, OUTLIERS);
            continue;
        }
        scene.settings.samples = 256;
        fixture_render(&drawn, gpu, &scene, &scene.settings);
        double off = rms_difference(&drawn, &truth);
        print_message("%s, 256 normals: RMSE %.3g\n", feature[i].name, off);
        assert_true(off < 0.02);
        rl_image_clear(&drawn);
    }
    rl_image_clear(&truth);
    rl_image_clear(&none);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_effects),
        cmocka_unit_test(test_lights),
        cmocka_unit_test(test_methods),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
