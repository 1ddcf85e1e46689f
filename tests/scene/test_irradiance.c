/* Illuminance at points against closed forms, and the flux that a lamp is given by against what arrives on a sphere around it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "model/photometry.h"
#include "model/plane.h"
#include "model/random.h"
#include "scene/irradiance.h"
#include "scene/scene_file.h"

static const uint64_t seed = 1924;
static const rl_vec3 up = {0.0, 1.0, 0.0};

/* The sound scene with these lights in place of its own. */
static void load_lights(struct rl_scene *scene, const char *lights)
{
    load_with(scene, 23, 32, lights);
}

/* All lights together, lx. */
static double illuminance(const struct rl_scene *scene, rl_vec3 P, rl_vec3 N)
{
    size_t n = scene->n_lights + scene->n_sources;
    double(*rgb)[3] = calloc(n, sizeof *rgb), sum = 0.0;
    assert_non_null(rgb);
    check_ok(rl_scene_irradiance(rgb, scene, P, v3_normalize(N), &error), &error);
    for (size_t i = 0; i < n; i++)
        sum += rl_luminance(rgb[i]);
    free(rgb);
    return sum;
}

/* ---- Closed forms ---- */

/* E = I cos/r^2 of a point, E cos of parallel light, and nothing from below. */
static void test_points(void **state)
{
    (void)state;
    struct rl_scene scene;
    load_lights(&scene, "lights: [{position: [0, 2, 0], flux: 800 lm, colour: [1, 0.5, 0.2]}]");
    double I = 800.0 / (4.0 * RL_PI);
    check_relative(illuminance(&scene, v3(0, 0, 0), up), I / 4.0, 1e-14);
    check_relative(illuminance(&scene, v3(1, 0, 0), up), I / 5.0 * 2.0 / sqrt(5.0), 1e-14);
    check_relative(illuminance(&scene, v3(0, 0, 0), v3(1, 1, 0)), I / 4.0 * sqrt(0.5), 1e-14);
    check_near(illuminance(&scene, v3(0, 0, 0), v3(1, 0, 0)), 0.0, 1e-14);
    check_near(illuminance(&scene, v3(0, 0, 0), v3(1, -1, 0)), 0.0, 0.0);
    double rgb[1][3];
    check_fails(rl_scene_irradiance(rgb, &scene, v3(0, 2, 0), up, &error), &error, RL_ERR_INPUT,
                "found the place of the light lights[0], expected a point away from it");
    rl_scene_clear(&scene);
    load_lights(&scene, "lights: [{direction: [0, -1, 1], illuminance: 100 klx}]");
    check_relative(illuminance(&scene, v3(5, 6, 7), up), 1e5 * sqrt(0.5), 1e-14);
    check_near(illuminance(&scene, v3(5, 6, 7), v3(0, 0, 1)), 0.0, 0.0);
    rl_scene_clear(&scene);
}

/* Of a radiometric scene, W/m^2 by channel. */
static void test_radiometric(void **state)
{
    (void)state;
    struct rl_scene scene;
    double rgb[1][3];
    load_lights(&scene, "lights: [{position: [0, 2, 0], intensity: [4, 8, 12]}]");
    check_ok(rl_scene_irradiance(rgb, &scene, v3(0, 0, 0), up, &error), &error);
    for (int c = 0; c < 3; c++)
        check_relative(rgb[0][c], c + 1.0, 1e-15);
    rl_scene_clear(&scene);
}

/* A panel a x b right above the point, at the height h: four times the form factor of a corner (Howell's catalogue, B-4). */
static double panel(double L, double a, double b, double h)
{
    double x = 0.5 * a / h, y = 0.5 * b / h, rx = sqrt(1.0 + x * x), ry = sqrt(1.0 + y * y);
    return 4.0 * RL_PI * L * (x / rx * atan(y / rx) + y / ry * atan(x / ry)) / (2.0 * RL_PI);
}

static void test_panels(void **state)
{
    (void)state;
    static const double size[][3] = {
        {0.6, 0.6, 2.0}, {0.6, 0.6, 0.01}, {1.2, 0.3, 3.0}, {10, 10, 0.5}, {1, 2, 50}};
    for (size_t i = 0; i < sizeof size / sizeof size[0]; i++) {
        struct rl_scene scene;
        char text[256];
        double a = size[i][0], b = size[i][1], h = size[i][2], L = 3600.0 / (RL_PI * a * b);
        snprintf(
            text, sizeof text,
            "lights:\n  - polygon: [[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]]\n    stretch: [%.17g, 1, "
            "%.17g]\n    translate: [0, %.17g, 0]\n    flux-per-side: 3600 lm",
            0.5 * a, 0.5 * b, h);
        load_lights(&scene, text);
        double E = illuminance(&scene, v3(0, 0, 0), up);
        check_relative(E, panel(L, a, b, h), 1e-12);
        check_relative(illuminance(&scene, v3(0, 2.0 * h, 0), v3(0, -1, 0)), E, 1e-12); /* the other side */
        /* And back: what a luxmeter reads gives the lamp's flux. */
        check_relative(E / panel(1.0, a, b, h) * RL_PI * a * b, 3600.0, 1e-12);
        rl_scene_clear(&scene);
    }
}

/* A disc as 64 sectors of 63 edges, 3968 of them on the rim: inside the disc, and less by at most 1 - sin(t)/t of its area. */
enum { SECTORS = 64, STEPS = 62, RIM = SECTORS * STEPS };

static void add_sector(char *text, size_t size, size_t *length, int sector, double R, double h)
{
    *length +=
        (size_t)snprintf(text + *length, size - *length, "  - {luminance: 5000, polygon: [[0, %.17g, 0]", h);
    for (int k = 0; k <= STEPS; k++) {
        double t = 2.0 * RL_PI * (sector * STEPS + k) / RIM;
        *length += (size_t)snprintf(text + *length, size - *length, ", [%.17g, %.17g, %.17g]", R * cos(t), h,
                                    R * sin(t));
    }
    *length += (size_t)snprintf(text + *length, size - *length, "]}\n");
}

static void test_discs(void **state)
{
    (void)state;
    enum { SIZE = 1 << 19 };
    static const double radius[] = {0.05, 0.3, 1.0, 10.0, 100.0};
    char *text = malloc(SIZE);
    assert_non_null(text);
    for (size_t i = 0; i < sizeof radius / sizeof radius[0]; i++) {
        double R = radius[i], h = 1.0, E = RL_PI * 5000.0 * R * R / (R * R + h * h);
        double short_of = 1.0 - sin(2.0 * RL_PI / RIM) / (2.0 * RL_PI / RIM);
        size_t length = (size_t)snprintf(text, SIZE,
                                         "camera: {position: [0, 1, 5], target: [0, 0, 0], "
                                         "field-of-view: 40}\nmaterials: [{name: matt}]\n"
                                         "objects: [{shape: sphere, material: matt}]\nlights:\n");
        for (int s = 0; s < SECTORS; s++)
            add_sector(text, SIZE, &length, s, R, h);
        struct rl_scene scene;
        put_file(path, text, length);
        check_ok(rl_scene_load(&scene, path, &error), &error);
        double found = illuminance(&scene, v3(0, 0, 0), up);
        print_message("disc of radius %g: %.9g lx, %.1e less than %.9g\n", R, found, 1.0 - found / E, E);
        assert_true(found <= E * (1.0 + 1e-12) && found >= E * (1.0 - short_of - 1e-12));
        rl_scene_clear(&scene);
    }
    free(text);
}

/* ---- Bodies ---- */

/* A sphere of radius 1 as a mesh of 2 N x N faces; every vertex is on it. Its poles are 2 N vertices each, and no two the same in double
 * precision; closed it is. */
static void put_sphere(const char *name)
{
    enum { N = 48, SIZE = 1 << 20 };
    char file[PATH_MAX], *text = malloc(SIZE);
    size_t length = 0;
    assert_non_null(text);
    for (int j = 0; j <= N; j++)
        for (int i = 0; i < 2 * N; i++) {
            double t = RL_PI * j / N, p = RL_PI * i / N;
            length += (size_t)snprintf(text + length, SIZE - length, "v %.9g %.9g %.9g\n", sin(t) * cos(p),
                                       cos(t), sin(t) * sin(p));
        }
    for (int j = 0; j < N; j++)
        for (int i = 0; i < 2 * N; i++) {
            int a = 1 + 2 * N * j + i, b = 1 + 2 * N * j + (i + 1) % (2 * N);
            if (j > 0)
                length += (size_t)snprintf(text + length, SIZE - length, "f %d %d %d\n", a, b, b + 2 * N);
            if (j < N - 1)
                length +=
                    (size_t)snprintf(text + length, SIZE - length, "f %d %d %d\n", a, b + 2 * N, a + 2 * N);
        }
    temporary_path(&folder, file, name);
    put_file(file, text, length);
    free(text);
}

/* A sphere of luminance L gives E = pi L (R/d)^2 cos as long as all of it is above the horizon; one of flux Phi = 4 pi^2 R^2 L so as a
 * point of Phi/(4 pi) would. The mesh is inside of the sphere, its silhouette smaller by less than 1/400. */
static void test_sphere(void **state)
{
    (void)state;
    struct rl_scene scene;
    put_sphere("sphere.obj");
    load_lights(&scene, "lights: [{mesh: sphere.obj, scale: 0.5, luminance: 1000}]");
    for (int i = 0; i < 8; i++) {
        double d = 0.6 + i * i;
        check_relative(illuminance(&scene, v3(0, 0, d), v3(0, 0, -1)), RL_PI * 1000.0 * 0.25 / (d * d),
                       0.0025);
    }
    check_relative(illuminance(&scene, v3(0, 0, 2), v3(0, 1, -1)), RL_PI * 1000.0 * 0.0625 * sqrt(0.5),
                   0.0025);
    rl_scene_clear(&scene);
    load_lights(&scene, "lights: [{mesh: sphere.obj, scale: 0.5, flux: 800 lm}]");
    check_relative(illuminance(&scene, v3(0, 3, 0), v3(0, -1, 0)), 800.0 / (4.0 * RL_PI * 9.0), 0.0025);
    rl_scene_clear(&scene);
}

/* A room whose walls all shine: E = pi L everywhere in it, whatever the normal. */
static void test_all_round(void **state)
{
    (void)state;
    struct rl_scene scene;
    load_lights(&scene, "lights:\n"
                        "  - {luminance: 7, polygon: [[0, 0, 0], [4, 0, 0], [4, 0, 5], [0, 0, 5]]}\n"
                        "  - {luminance: 7, polygon: [[0, 3, 0], [4, 3, 0], [4, 3, 5], [0, 3, 5]]}\n"
                        "  - {luminance: 7, polygon: [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]]}\n"
                        "  - {luminance: 7, polygon: [[0, 0, 5], [4, 0, 5], [4, 3, 5], [0, 3, 5]]}\n"
                        "  - {luminance: 7, polygon: [[0, 0, 0], [0, 0, 5], [0, 3, 5], [0, 3, 0]]}\n"
                        "  - {luminance: 7, polygon: [[4, 0, 0], [4, 0, 5], [4, 3, 5], [4, 3, 0]]}");
    for (uint64_t i = 0; i < 200; i++) {
        double u[6];
        for (uint64_t k = 0; k < 6; k++)
            u[k] = rl_random_uniform(seed, 6 * i + k);
        rl_vec3 N = v3(u[3] - 0.5, u[4] - 0.5, u[5] - 0.5);
        check_relative(illuminance(&scene, v3(4 * u[0], 3 * u[1], 5 * u[2]), N), 7.0 * RL_PI, 1e-12);
    }
    rl_scene_clear(&scene);
}

/* ---- Sheets ---- */

static void put_sheet(const char *name, const char *text)
{
    char file[PATH_MAX];
    temporary_path(&folder, file, name);
    put_file(file, text, strlen(text));
}

/* What the light gives as a point, the effects' sum for an irradiance of 1 left out. */
static double as_point(const struct rl_scene *scene, rl_vec3 P)
{
    struct rl_incident incident;
    struct rl_point_light point = rl_light_as_point(&scene->light[0]);
    assert_true(rl_incident_from_centroid(&incident, &point, P, RL_UNIT_DOUBLE));
    return incident.irradiance[0];
}

/* An open flat mesh is its outline's polygon, to every effect, however its triangles are wound: the same area, normal and radiance. */
static void test_flat_sheets(void **state)
{
    (void)state;
    static const struct {
        const char *mesh, *polygon, *placement;
    } rows[] = {
        {"v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3\nf 1 3 4\n",
         "[[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]]", "translate: [0, 2, 0]"},
        {"v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3\nf 1 4 3\n",
         "[[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]]",
         "scale: 0.3, rotate: [20, 30, 40], translate: [0.5, 2, 0.25]"},
        {"v -1 0 -1\nv 1 0 -1\nv 1 0 1\nf 1 2 3\n", "[[-1, 0, -1], [1, 0, -1], [1, 0, 1]]",
         "translate: [0, 2, 0]"},
        {"v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3\nf 1 3 4\n",
         "[[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]]",
         "scale: 0.01, rotate: [20, 30, 40], translate: [40, 30, 20]"},
    };
    static const rl_vec3 at[] = {{0, 0, 0}, {3, -1, 2}, {0.5, 5, 0.7}, {-8, 1.9, 0}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_scene mesh, polygon;
        char text[512];
        put_sheet("sheet.obj", rows[i].mesh);
        snprintf(text, sizeof text, "lights: [{mesh: sheet.obj, radiance: [1, 1, 1], %s}]",
                 rows[i].placement);
        load_lights(&mesh, text);
        snprintf(text, sizeof text, "lights: [{polygon: %s, radiance: [1, 1, 1], %s}]", rows[i].polygon,
                 rows[i].placement);
        load_lights(&polygon, text);
        check_relative(mesh.light[0].area, polygon.light[0].area, 1e-3);
        for (size_t k = 0; k < sizeof at / sizeof at[0]; k++)
            for (double side = -1.0; side <= 1.0; side += 2.0) {
                /* Of the last one vertices are rounded to 4e-4 of its size. */
                double room = i == 3 ? 2e-3 : 2e-6, E = illuminance(&polygon, at[k], v3(0.1, side, 0.2));
                check_near(illuminance(&mesh, at[k], v3(0.1, side, 0.2)), E, room * E + 1e-9);
                check_relative(as_point(&mesh, at[k]), as_point(&polygon, at[k]), room);
            }
        rl_scene_clear(&mesh);
        rl_scene_clear(&polygon);
    }
}

/* One that bends counts in full where it hides nothing of itself; as a point it has no normal and half of its area, its mean silhouette. */
static void test_bent_sheet(void **state)
{
    (void)state;
    struct rl_scene bent, sides;
    put_sheet("bent.obj",
              "v -1 2 0\nv 1 2 0\nv 1 3 1\nv -1 3 1\nv 1 3 -1\nv -1 3 -1\nf 1 2 3 4\nf 1 2 5 6\n");
    load_lights(&bent, "lights: [{mesh: bent.obj, luminance: 1000}]");
    load_lights(&sides, "lights:\n"
                        "  - {luminance: 1000, polygon: [[-1, 2, 0], [1, 2, 0], [1, 3, 1], [-1, 3, 1]]}\n"
                        "  - {luminance: 1000, polygon: [[-1, 2, 0], [1, 2, 0], [1, 3, -1], [-1, 3, -1]]}");
    check_relative(illuminance(&bent, v3(0, 0, 0), up), illuminance(&sides, v3(0, 0, 0), up), 1e-12);
    struct rl_point_light point = rl_light_as_point(&bent.light[0]);
    check_vec3(point.normal, 0.0, 0.0, 0.0, 0.0);
    check_relative(point.area, 2.0 * sqrt(2.0), 1e-12);
    rl_scene_clear(&bent);
    rl_scene_clear(&sides);
}

/* ---- Flux ---- */

/* What arrives on the inside of a sphere about the origin, by Gauss's rule in rings (of 2 points in each) and evenly around. */
static double flux_through(const struct rl_scene *scene, double R)
{
    enum { RINGS = 120, SPOKES = 240 };
    double sum = 0.0;
    for (int i = 0; i < RINGS; i++)
        for (int half = -1; half <= 1; half += 2)
            for (int j = 0; j < SPOKES; j++) {
                double y = (2.0 * i + 1.0 + half / sqrt(3.0)) / RINGS - 1.0, r = sqrt(1.0 - y * y);
                double p = 2.0 * RL_PI * (j + 0.37) / SPOKES;
                rl_vec3 d = v3(r * cos(p), y, r * sin(p));
                sum += illuminance(scene, v3_scale(R, d), v3_scale(-1.0, d));
            }
    return sum * 4.0 * RL_PI * R * R / (2.0 * RINGS * SPOKES);
}

static void put_box(void)
{
    static const char box[] = "v -0.5 -1 -1.5\nv 0.5 -1 -1.5\nv -0.5 1 -1.5\nv 0.5 1 -1.5\n"
                              "v -0.5 -1 1.5\nv 0.5 -1 1.5\nv -0.5 1 1.5\nv 0.5 1 1.5\n"
                              "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    char name[PATH_MAX];
    temporary_path(&folder, name, "box.obj");
    put_file(name, box, sizeof box - 1);
}

/* The lamp's flux is what a goniometer would find: of a box, a polygon (its back, too), a point, off the centre, and all at once. */
static void test_flux(void **state)
{
    (void)state;
    static const struct {
        const char *lights;
        double flux;
    } rows[] = {
        {"{mesh: box.obj, flux: 1000 lm}", 1000.0},
        {"{mesh: box.obj, flux: 1000 lm, rotate: [20, 30, 40], translate: [0.5, 0.3, -0.4]}", 1000.0},
        {"{mesh: box.obj, luminance: 100 cd/m2}", 100.0 * RL_PI * 22.0},
        {"{polygon: [[-1, 0, -1], [1, 0, -1], [0.5, 0, 1]], flux: 1000 lm, rotate: [30, 0, 10]}", 1000.0},
        {"{polygon: [[-1, 0, -1], [1, 0, -1], [0.5, 0, 1]], flux-per-side: 1000 lm}", 2000.0},
        {"{polygon: [[-1, 0, -1], [1, 0, -1], [0.5, 0, 1]], luminous-intensity: 100 cd}", 200.0 * RL_PI},
        {"{position: [0.5, 1, 0], flux: 1000 lm}", 1000.0},
        {"{position: [0.5, 1, 0], luminous-intensity: 100 cd}", 400.0 * RL_PI},
        {"{position: [0, 0, 1], flux: 1 klm}, {mesh: box.obj, flux: 2 klm}", 3000.0},
    };
    put_box();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_scene scene;
        char text[256];
        snprintf(text, sizeof text, "lights: [%s]", rows[i].lights);
        load_lights(&scene, text);
        double found = flux_through(&scene, 3.0);
        print_message("%9.3f lm, off by %8.1e: %s\n", found, found / rows[i].flux - 1.0, rows[i].lights);
        check_relative(found, rows[i].flux, 2e-5);
        rl_scene_clear(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points),      cmocka_unit_test(test_radiometric),
        cmocka_unit_test(test_panels),      cmocka_unit_test(test_discs),
        cmocka_unit_test(test_sphere),      cmocka_unit_test(test_all_round),
        cmocka_unit_test(test_flat_sheets), cmocka_unit_test(test_bent_sheet),
        cmocka_unit_test(test_flux),
    };
    print_message("seed %llu\n", (unsigned long long)seed);
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
