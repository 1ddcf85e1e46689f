/* Sound scene files: what is read, what is left out, where things are placed, lights and hash. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/scene_file.h"
#include "scene/teapot.h"

static void test_as_written(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 0, -1, NULL);
    assert_string_equal(s.path, path);
    assert_int_equal(s.width, 64);
    assert_int_equal(s.height, 48);
    assert_int_equal(s.n_materials, 2);
    assert_string_equal(s.material[0].name, "shiny");
    check_near(s.material[0].rr, 30.0, 0.0);
    check_near(rl_effect_given(&s.material[0], rl_effect_find("diffuse"))[2], 0.3, 0.0);
    assert_null(rl_effect_given(&s.material[0], rl_effect_find("ambient")));
    check_near(s.material[0].specular[1], 1.0, 0.0);
    assert_string_equal(s.material[0].method, "random");
    assert_null(s.material[1].method);
    assert_int_equal(s.n_objects, 2);
    assert_string_equal(s.object[1].name, "ground");
    assert_int_equal(s.object[0].material, 0);
    assert_int_equal(s.object[1].material, 1);
    assert_int_equal(s.object[0].mesh.n_triangles, 2 * (2 * 4 - 1) * 16);
    check_vec3(s.object[1].centre, 0.0, -1.0, 0.0, 0.0);
    check_near(s.object[1].radius, sqrt(2.0), 1e-7);
    assert_int_equal(s.n_lights, 2);
    check_near(s.light[0].radiance[2], 3.0, 0.0);
    assert_int_equal(s.settings.samples, 16);
    assert_int_equal(s.settings.margin_kind, RL_MARGIN_OFF);
    assert_int_equal(s.settings.normal_bits, 8);
    rl_scene_clear(&s);
    assert_null(s.path);
}

static void test_defaults(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 1, 1, "");
    assert_int_equal(s.width, 640);
    assert_int_equal(s.height, 480);
    rl_scene_clear(&s);
    load_with(&s, 23, 35, "");
    assert_int_equal(s.n_lights, 0);
    assert_int_equal(s.settings.samples, 0);
    assert_true(s.settings.attenuation);
    rl_scene_clear(&s);
    load_with(&s, 23, 32, "lights: []");
    assert_int_equal(s.n_lights, 0);
    rl_scene_clear(&s);
    load_with(&s, 11, 11, ""); /* rr without highlight: the paper's method */
    assert_string_equal(s.material[0].method, "random");
    rl_scene_clear(&s);
    load_with(&s, 11, 11, "    highlight: none");
    assert_null(s.material[0].method);
    assert_int_equal(s.material[0].interpolation, RL_INTERPOLATION_PHONG);
    rl_scene_clear(&s);
    load_with(&s, 11, 13, "    interpolation: gouraud\n  - name: matt\n    interpolation: constant");
    assert_int_equal(s.material[0].interpolation, RL_INTERPOLATION_GOURAUD);
    assert_int_equal(s.material[1].interpolation, RL_INTERPOLATION_CONSTANT);
    assert_int_equal(s.settings.interpolation, RL_INTERPOLATION_OF_MATERIAL);
    rl_scene_clear(&s);
    load_with(&s, 15, 15, "  - shape: disc\n    material: matt\n  - name: ball");
    assert_string_equal(s.object[0].name, "objects[0]");
    assert_string_equal(s.object[1].name, "ball");
    rl_scene_clear(&s);
}

/* Lights without shape, between two with one. */
static void test_sources(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 26, 26,
              "    radiance: [1, 2, 3]\n  - name: bulb\n    position: [1, 2, 3]\n    intensity: [4, 5, 6]\n"
              "  - direction: [0, -2, 0]\n    irradiance: [7, 8, 9]");
    assert_int_equal(s.n_lights, 2);
    assert_string_equal(s.light[1].name, "triangle");
    assert_int_equal(s.n_sources, 2);
    assert_string_equal(s.source[0].name, "bulb");
    assert_false(s.source[0].parallel);
    check_vec3(s.source[0].at, 1.0, 2.0, 3.0, 0.0);
    check_near(s.source[0].strength[1], 5.0, 0.0);
    assert_string_equal(s.source[1].name, "lights[2]");
    assert_true(s.source[1].parallel);
    check_vec3(s.source[1].at, 0.0, 1.0, 0.0, 0.0); /* towards where the light comes from */
    check_near(s.source[1].strength[2], 9.0, 0.0);
    rl_scene_clear(&s);
    load_with(&s, 24, 32, "  - {direction: [0, -2, 0], irradiance: [7, 8, 9]}");
    assert_int_equal(s.n_lights, 0);
    assert_int_equal(s.n_sources, 1);
    rl_scene_clear(&s);
}

/* Values as written, those left out by default or not at all. */
static void test_effects(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 13, 13,
              "    diffuse: [0.1, 0.2, 0.3]\n"
              "    cook-torrance: {n: [1, 2, 3], k: [4, 5, 6], roughness: 0.25, distribution: ellipsoid}");
    const double *value = rl_effect_given(&s.material[1], rl_effect_find("cook-torrance"));
    assert_true(isnan(value[0]) && isnan(value[2]));
    check_near(value[4], 2.0, 0.0);
    check_near(value[8], 6.0, 0.0);
    check_near(value[9], 0.25, 0.0);
    check_near(value[10], 1.0, 0.0);
    assert_string_equal(rl_effect_module(rl_effect_find("cook-torrance"), value, 4),
                        "common/ellipsoid_facets");
    assert_null(rl_effect_given(&s.material[1], rl_effect_find("ambient")));
    assert_null(rl_effect_given(&s.material[0], rl_effect_find("cook-torrance")));
    rl_scene_clear(&s);

    load_with(&s, 13, 13, "    lengyel: {diffuse: [0, 0, 0], specular: [0, 0.5, 0]}");
    value = rl_effect_given(&s.material[1], rl_effect_find("lengyel"));
    check_near(value[4], 0.5, 0.0);
    check_near(value[6], 8.0, 0.0); /* the exponent's default */
    check_near(value[7], 0.0, 0.0);
    assert_true(rl_effect_wanted(&s.material[1], rl_effect_find("lengyel")));
    rl_scene_clear(&s);
}

static void test_render_block(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(
        &s, 34, 35,
        "  samples: 1024\n  normal-bits: float\n  normal-size: 64\n  env-size: 8\n  env-format: rgba32f\n"
        "  margin: 0.5\n  attenuation: off\n  frame: printed\n  seed: 18446744073709551615\n  tolerance: "
        "1e-9");
    assert_int_equal(s.settings.samples, 1024);
    assert_int_equal(s.settings.normal_bits, RL_NORMAL_BITS_FLOAT);
    assert_int_equal(s.settings.normal_size, 64);
    assert_int_equal(s.settings.env_size, 8);
    assert_int_equal(s.settings.env_format, RL_TEXEL_RGBA32F);
    assert_int_equal(s.settings.margin_kind, RL_MARGIN_VALUE);
    check_near(s.settings.margin, 0.5, 0.0);
    assert_false(s.settings.attenuation);
    assert_int_equal(s.settings.frame, RL_FRAME_PRINTED);
    assert_true(s.settings.seed == UINT64_MAX);
    check_near(s.settings.tolerance, 1e-9, 0.0);
    rl_scene_clear(&s);
    load_with(&s, 35, 35, "  attenuation: true\n  margin: auto\n  normal-bits: 12");
    assert_true(s.settings.attenuation);
    assert_int_equal(s.settings.margin_kind, RL_MARGIN_AUTO);
    check_near(s.settings.margin_bound, 0.02, 0.0);
    assert_int_equal(s.settings.normal_bits, 12);
    rl_scene_clear(&s);
}

/* Scale and stretch first, then x, y and z, then the way: by hand for the vertex (1, 0, 0) of a triangle. */
static void test_placement(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double x, y, z;
    } cases[] = {
        {"    translate: [1, 2, 3]", 2, 2, 3},
        {"    scale: 2\n    stretch: [3, 1, 1]\n    translate: [1, 2, 3]", 7, 2, 3},
        {"    rotate: [0, 0, 90]", 0, 1, 0},
        {"    rotate: [0, 90, 0]", 0, 0, -1},
        {"    rotate: [0, 90, 90]", 0, 0, -1}, /* y takes x to -z, which z leaves alone */
        {"    rotate: [90, 0, 90]", 0, 1, 0},  /* x leaves x alone, z takes it to y */
        {"    stretch: [2, 5, 7]\n    rotate: [0, 0, 90]\n    translate: [0, 0, 1]", 0, 2, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[256];
        snprintf(text, sizeof text, "    polygon: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n%s", cases[i].text);
        struct rl_scene s;
        load_with(&s, 25, 25, text);
        check_vec3(s.light[0].polygon[0].vertex[0], cases[i].x, cases[i].y, cases[i].z, 1e-12);
        rl_scene_clear(&s);
    }
}

/* (a, b) turned by an angle: one axis' rotation, in the plane of the other two. */
static void turn(double *a, double *b, double degrees)
{
    double c = cos(degrees * RL_PI / 180.0), s = sin(degrees * RL_PI / 180.0), old = *a;
    *a = c * old - s * *b;
    *b = s * old + c * *b;
}

/* All three axes through one general rotation, against one turn after the other. */
static void test_rotation(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(
        &s, 25, 25,
        "    polygon: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n    rotate: [30, -40, 155]\n    stretch: [1, 2, 3]");
    for (int i = 0; i < 3; i++) {
        double p[3] = {i == 0 ? 1.0 : 0.0, i == 1 ? 2.0 : 0.0, i == 2 ? 3.0 : 0.0};
        turn(&p[1], &p[2], 30.0);
        turn(&p[2], &p[0], -40.0);
        turn(&p[0], &p[1], 155.0);
        check_vec3(s.light[0].polygon[0].vertex[i], p[0], p[1], p[2], 1e-12);
    }
    rl_scene_clear(&s);
}

/* A stretched sphere is an ellipsoid, and its normals are known: (x/a^2, y/b^2, z/c^2). */
static void test_stretched_normals(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 18, 18, "    stretch: [2, 1, 0.5]\n    scale: 10");
    const struct rl_mesh *mesh = &s.object[0].mesh;
    for (size_t i = 0; i < mesh->n_vertices; i++) {
        const float *p = mesh->position[i], *n = mesh->normal[i];
        rl_vec3 expected = v3_normalize(v3(p[0] / 4.0, p[1], p[2] / 0.25));
        check_vec3(v3(n[0], n[1], n[2]), expected.x, expected.y, expected.z, 1e-6);
    }
    check_near(s.object[0].radius, 20.0, 1e-5);
    rl_scene_clear(&s);
}

static void test_lights(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 0, -1, NULL);
    const struct rl_light *quad = &s.light[0];
    assert_int_equal(quad->n_polygons, 1);
    check_near(quad->area, 4.0, 1e-12);
    check_vec3(quad->centroid, 0.0, 3.0, 2.0, 1e-12);
    check_near(quad->radius, sqrt(2.0), 0.01 * sqrt(2.0));
    for (size_t i = 0; i < s.n_lights; i++)
        for (int k = 0; k < s.light[i].polygon[0].n; k++)
            assert_true(v3_length(v3_sub(s.light[i].polygon[0].vertex[k], s.light[i].centre)) <=
                        s.light[i].radius);
    /* The right triangle's smallest sphere sits on its longest edge. */
    check_near(s.light[1].radius, sqrt(0.5), 0.01);
    check_vec3(s.light[1].centroid, 3.0, 1.0 / 3.0, 1.0 / 3.0, 1e-12);
    struct rl_point_light point = rl_light_as_point(quad);
    check_vec3(point.position, 0.0, 3.0, 2.0, 1e-12);
    check_near(fabs(point.normal.y), 1.0, 1e-12);
    check_near(point.radiance[1], 2.0, 0.0);
    rl_scene_clear(&s);
}

static void write_text(const char *name, const char *text)
{
    char file[PATH_MAX];
    temporary_path(&folder, file, name);
    check_ok(rl_file_write(file, text, strlen(text), &error), &error);
}

static const char tetrahedron[] = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\n"
                                  "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 1 1 2\n";

/* As a light a tetrahedron of edge sqrt(8) has four triangles of area 2 sqrt(3); the fifth, without area,
 * is dropped. */
static void test_mesh_light(void **state)
{
    (void)state;
    write_text("light.obj", tetrahedron);
    struct rl_scene s;
    load_with(&s, 25, 25, "    mesh: light.obj\n    translate: [0, 5, 0]");
    assert_int_equal(s.light[0].n_polygons, 4);
    check_relative(s.light[0].area, 0.25 * 4.0 * 2.0 * sqrt(3.0), 1e-6);
    check_vec3(s.light[0].centroid, 0.0, 5.0, 0.0, 1e-6);
    check_near(s.light[0].radius, sqrt(3.0), 0.02);
    check_vec3(rl_light_as_point(&s.light[0]).normal, 0.0, 0.0, 0.0, 0.0);
    rl_scene_clear(&s);
}

/* The hash follows the scene's bytes and the mesh's, and nothing else. */
static void test_hash(void **state)
{
    (void)state;
    write_text("light.obj", tetrahedron);
    struct rl_scene a, b, c, d;
    load_with(&a, 25, 25, "    mesh: light.obj");
    load_with(&b, 25, 25, "    mesh: light.obj");
    load_with(&c, 25, 25, "    mesh: light.obj # the same");
    write_text("light.obj", "# a comment\nv 1 1 1\nv -1 -1 1\nv -1 1 -1\nf 1 2 3\n");
    load_with(&d, 25, 25, "    mesh: light.obj");
    assert_true(a.hash == b.hash);
    assert_true(a.hash != c.hash);
    assert_true(a.hash != d.hash);
    rl_scene_clear(&a);
    rl_scene_clear(&b);
    rl_scene_clear(&c);
    rl_scene_clear(&d);
}

/* The scenes that come with the program. */
static void test_scenes(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        size_t objects, lights;
    } cases[] = {
        {"studies/scenes/teapot-star.yaml", 2, 1},
        {"studies/scenes/sphere-quad.yaml", 1, 1},
        {"studies/scenes/two-roughness.yaml", 3, 1},
        {"studies/scenes/three-lights.yaml", 2, 3},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct rl_scene s;
        check_ok(rl_scene_load(&s, cases[i].path, &error), &error);
        assert_int_equal(s.n_objects, cases[i].objects);
        assert_int_equal(s.n_lights, cases[i].lights);
        assert_int_equal(s.width, 640);
        assert_int_equal(s.height, 480);
        rl_scene_clear(&s);
    }
}

/* The angle between the mirror direction at the body's best point (patches 4 to 11) for this vertex of the
 * light, and that vertex. The teapot stands as it is made. */
static double closest_mirror(const struct rl_scene *s, rl_vec3 vertex)
{
    enum { STEPS = 100 };
    double closest = RL_PI;
    for (int k = 0; k < 8 * STEPS * STEPS; k++) {
        rl_vec3 P, N;
        rl_teapot_evaluate(4 + k / (STEPS * STEPS), (double)(k % STEPS) / STEPS,
                           (double)(k / STEPS % STEPS) / STEPS, &P, &N);
        rl_vec3 V = v3_normalize(v3_sub(s->camera.position, P));
        rl_vec3 L = v3_normalize(v3_sub(vertex, P));
        if (v3_dot(N, V) > 0.0)
            closest = fmin(closest, acos(fmin(1.0, v3_dot(v3_reflect(V, N), L))));
    }
    return closest;
}

/* Every vertex of the star has its image on the front of the body, to the grid's 1 degree: the whole star
 * is to be seen there. */
static void test_star_is_in_view(void **state)
{
    (void)state;
    struct rl_scene s;
    check_ok(rl_scene_load(&s, "studies/scenes/teapot-star.yaml", &error), &error);
    const struct rl_polygon *star = &s.light[0].polygon[0];
    assert_int_equal(star->n, 10);
    check_near(s.material[0].rr, 30.0, 0.0);
    for (int k = 0; k < star->n; k++)
        check_near(closest_mirror(&s, star->vertex[k]), 0.0, RL_PI / 180.0);
    rl_scene_clear(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_as_written),   cmocka_unit_test(test_defaults),
        cmocka_unit_test(test_sources),      cmocka_unit_test(test_effects),
        cmocka_unit_test(test_render_block), cmocka_unit_test(test_placement),
        cmocka_unit_test(test_rotation),     cmocka_unit_test(test_stretched_normals),
        cmocka_unit_test(test_lights),       cmocka_unit_test(test_mesh_light),
        cmocka_unit_test(test_hash),

        cmocka_unit_test(test_scenes),       cmocka_unit_test(test_star_is_in_view),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
