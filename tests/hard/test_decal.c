/* P in a light's plane sees nothing of the light (src/model/plane.h): planes at any angle, P inside of the light, on an edge, at a corner and
 * beside it; in probes of both backends, by every integrator, and on a floor by every method. */
#include "gpu/against_cpu.h"

#include "base/files.h"
#include "model/random.h"
#include "probe/probe.h"
#include "reference/integrators.h"
#include "support/temporary.h"

enum { PLANES = 1000, TURNS = 12 };
static const uint64_t seed = 20261130;

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

static double uniform(uint64_t *index, double low, double high)
{
    return low + (high - low) * rl_random_uniform(seed, (*index)++);
}

static rl_vec3 direction(uint64_t *index)
{
    return v3_normalize(v3(uniform(index, -1.0, 1.0), uniform(index, -1.0, 1.0), uniform(index, -1.0, 1.0)));
}

/* A plane's two axes, any pair of unequal directions. */
struct axes {
    rl_vec3 u, w;
};

/* Triangles about 0: inside, on an edge, at a corner, beside. */
static const double corners[][3][2] = {
    {{1.0, 0.0}, {-0.3, 1.0}, {-0.5, -0.7}},
    {{1.0, 0.5}, {-2.0, -1.0}, {0.0, 1.0}},
    {{0.0, 0.0}, {1.0, 0.3}, {0.2, 1.0}},
    {{1.0, 1.0}, {2.0, 1.0}, {1.0, 3.0}},
};
enum { WHERES = sizeof corners / sizeof corners[0] };

static rl_vec3 place(const struct axes *a, const double at[2])
{
    return v3_madd(v3_scale(at[0], a->u), at[1], a->w);
}

/* No needles come of these: of their planes rounding leaves little. */
static struct axes draw_axes(uint64_t *index)
{
    struct axes a;
    do
        a = (struct axes){direction(index), direction(index)};
    while (v3_length(v3_cross(a.u, a.w)) < 0.5);
    return a;
}

static void fill_row(double *row, uint64_t *index, size_t where)
{
    const struct axes a = draw_axes(index);
    rl_vec3 N = direction(index);
    double size = exp(uniform(index, -20.0, 20.0));
    const rl_vec3 vectors[] = {N, N, place(&a, corners[where][0]), place(&a, corners[where][1]),
                               place(&a, corners[where][2])};
    for (size_t i = 0; i < 5; i++) {
        double scale = i < 2 ? 1.0 : size;
        row[3 * i] = scale * vectors[i].x;
        row[3 * i + 1] = scale * vectors[i].y;
        row[3 * i + 2] = scale * vectors[i].z;
    }
    row[15] = row[16] = row[17] = 1.0;
}

static void test_probes(void **state)
{
    (void)state;
    static double rows[WHERES * PLANES][RL_PROBE_IN_MAX], packed[WHERES * PLANES * 18],
        c[WHERES * PLANES * 3], glsl[WHERES * PLANES * 3];
    struct rl_error error;
    struct rl_probe p;
    uint64_t index = 0;
    size_t k = 0, n = WHERES * PLANES;
    print_message("seed %llu\n", (unsigned long long)seed);
    while (rl_probe_at(&p, k) && strcmp(p.name, "diffuse-area-polygon") != 0)
        k++;
    assert_int_equal(p.n_in, 18);
    for (size_t i = 0; i < n; i++) {
        fill_row(rows[i], &index, i % WHERES);
        memcpy(packed + 18 * i, rows[i], 18 * sizeof(double));
    }
    rl_probe_cpu(&p, packed, n, c);
    check_ok(rl_probe_gpu(&p, gpu, packed, n, glsl, &error), &error);
    for (size_t i = 0; i < 3 * n; i++)
        if (c[i] != 0.0 || glsl[i] != 0.0)
            fail_msg("row %zu: %g in C, %g in GLSL, expected 0", i / 3, c[i], glsl[i]);
    /* Off the plane by a thousandth it is seen. */
    for (size_t i = 0; i < n; i++)
        for (size_t v = 2; v < 5; v++)
            for (size_t x = 0; x < 3; x++)
                packed[18 * i + 3 * v + x] += 1e-3 * (x + 1) * fabs(rows[i][9]);
    rl_probe_cpu(&p, packed, n, c);
    check_ok(rl_probe_gpu(&p, gpu, packed, n, glsl, &error), &error);
    size_t seen = 0, seen_glsl = 0;
    for (size_t i = 0; i < n; i++) {
        seen += c[3 * i] > 0.0;
        seen_glsl += glsl[3 * i] > 0.0;
    }
    assert_true(2 * seen > n);
    assert_true(2 * seen_glsl > n);
}

static void test_integrators(void **state)
{
    (void)state;
    const double at[][2] = {{0.2, 0.1}, {0.5, 0.5}, {1.0, 0.0}, {3.0, 1.0}},
                 square[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    uint64_t index = 1u << 20;
    struct rl_error error;
    for (int i = 0; i < 40; i++) {
        const struct axes a = draw_axes(&index);
        rl_vec3 offset = v3_scale(3.0, direction(&index)), vertex[4];
        for (size_t k = 0; k < 4; k++)
            vertex[k] = v3_add(offset, place(&a, square[k]));
        struct rl_polygon polygon = {.vertex = vertex, .n = 4};
        const struct rl_light light = {.polygon = &polygon, .n_polygons = 1, .radiance = {1.0, 1.0, 1.0}};
        struct rl_light_set *set;
        check_ok(rl_light_set_make(&set, &light, 1, &error), &error);
        rl_vec3 N = v3_normalize(v3_cross(a.u, a.w));
        const struct rl_surface s = {v3_add(offset, place(&a, at[i % 4])), N,
                                     v3_normalize(v3_madd(N, 0.3, direction(&index)))};
        const struct rl_ellipsoid e = rl_ellipsoid_make(5.0);
        for (size_t k = 0; k < rl_n_integrators; k++) {
            const struct rl_integrate_options options = {
                .attenuation = true, .tolerance = 1e-3, .max_evaluations = 10000, .env_size = 16};
            struct rl_estimate estimate;
            check_ok(rl_integrators[k]->integrate(&estimate, &s, &e, set, &options, &error), &error);
            if (estimate.value[0] != 0.0)
                fail_msg("%s: %g, expected 0", rl_integrators[k]->name, estimate.value[0]);
        }
        rl_light_set_free(set);
    }
}

static void load(struct rl_scene *scene, uint64_t *index)
{
    struct rl_error error;
    struct temporary t = {0};
    char path[PATH_MAX], text[1024], turn[96];
    snprintf(turn, sizeof turn, "rotate: [%.3f, %.3f, %.3f]", uniform(index, -25.0, 25.0),
             uniform(index, -25.0, 25.0), uniform(index, -25.0, 25.0));
    int n = snprintf(
        text, sizeof text,
        "film: {width: 32, height: 24}\ncamera: {position: [0, 4, 4], target: [0, 0, 0], field-of-view: 40}\n"
        "materials:\n  - {name: m, rr: 5, diffuse-area: [1, 1, 1], highlight: random}\n"
        "objects:\n  - {shape: plane, scale: 3, %s, material: m}\nrender: {culling: off}\n"
        "lights:\n  - {polygon: [[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], %s, radiance: [1, 1, 1]}\n",
        turn, turn);
    assert_in_range(n, 1, sizeof text - 1);
    temporary_make(&t);
    temporary_path(&t, path, "decal.yaml");
    check_ok(rl_file_write(path, text, (size_t)n, &error), &error);
    check_ok(rl_scene_load(scene, path, &error), &error);
    temporary_remove(&t);
}

static void check_dark(struct rl_image *image, const char *method, const char *where)
{
    size_t lit = 0, foreground = 0;
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++) {
        const float *p = image->data + 4 * i;
        foreground += p[3] > 0.0f;
        lit += p[0] != 0.0f || p[1] != 0.0f || p[2] != 0.0f;
    }
    assert_true(foreground > 0);
    rl_image_clear(image);
    if (lit > 0)
        fail_msg("%s on the %s: %zu of %zu pixels are lit, expected none", method, where, lit, foreground);
}

/* Without `plain`, which knows nothing of a light's shape: a centroid on the horizon is above or below it. */
static void test_floors(void **state)
{
    (void)state;
    uint64_t index = 1u << 21;
    for (int i = 0; i < TURNS; i++)
        for (size_t m = 0; m < rl_n_methods; m++) {
            struct rl_scene scene;
            struct rl_image image;
            if (strcmp(rl_methods[m]->name, "plain") == 0)
                continue;
            load(&scene, &index);
            scene.settings.method = rl_methods[m]->name;
            scene.settings.env_size = 16;
            scene.settings.tolerance = 1e-4;
            if (rl_methods[m]->on_gpu) {
                fixture_render(&image, gpu, &scene, &scene.settings);
                check_dark(&image, rl_methods[m]->name, "GPU");
            }
            if (rl_methods[m]->on_cpu) {
                render_cpu(&image, &scene);
                check_dark(&image, rl_methods[m]->name, "CPU");
            }
            rl_scene_clear(&scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_probes),
        cmocka_unit_test(test_integrators),
        cmocka_unit_test(test_floors),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
