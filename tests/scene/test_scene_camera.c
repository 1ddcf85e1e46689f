/* The camera of a scene: rays and matrix agree, and the planes enclose the objects. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/scene_file.h"

/* clip = matrix (p, 1) */
static void transform(const double m[16], rl_vec3 p, double clip[4])
{
    for (int r = 0; r < 4; r++)
        clip[r] = m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r];
}

static void test_camera(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 0, -1, NULL);
    const struct rl_camera *c = &s.camera;
    check_near(v3_dot(c->right, c->up), 0.0, 1e-15);
    check_near(v3_dot(v3_cross(c->right, c->up), c->forward), -1.0, 1e-15);
    check_vec3(c->right, 1.0, 0.0, 0.0, 1e-15);
    double m[16], clip[4];
    rl_camera_matrix(c, s.width, s.height, false, m);
    /* The ray through a pixel's centre meets the same pixel through the matrix; y = 0 is the top row. */
    static const int pixels[][2] = {{0, 0}, {63, 47}, {10, 40}, {31, 23}};
    for (size_t i = 0; i < 4; i++) {
        rl_vec3 ray = rl_camera_ray(c, s.width, s.height, pixels[i][0], pixels[i][1]);
        check_near(v3_length(ray), 1.0, 1e-15);
        transform(m, v3_madd(c->position, 3.7, ray), clip);
        check_near((clip[0] / clip[3] + 1.0) / 2.0 * s.width, pixels[i][0] + 0.5, 1e-9);
        check_near((1.0 - clip[1] / clip[3]) / 2.0 * s.height, pixels[i][1] + 0.5, 1e-9);
    }
    transform(m, v3_madd(c->position, c->near_plane, c->forward), clip);
    check_near(clip[2] / clip[3], -1.0, 1e-12);
    transform(m, v3_madd(c->position, c->far_plane, c->forward), clip);
    check_near(clip[2] / clip[3], 1.0, 1e-12);
    /* Reversed: 1 and 0, and the same picture. */
    double r[16], reversed[4];
    rl_camera_matrix(c, s.width, s.height, true, r);
    transform(r, v3_madd(c->position, c->near_plane, c->forward), reversed);
    check_near(reversed[2] / reversed[3], 1.0, 1e-12);
    transform(r, v3_madd(c->position, c->far_plane, c->forward), reversed);
    check_near(reversed[2] / reversed[3], 0.0, 1e-12);
    for (int i = 0; i < 16; i++)
        assert_true(i % 4 == 2 || r[i] == m[i]);
    /* The top edge of the film is half the field of view up. */
    rl_vec3 top = v3_normalize(v3_madd(c->forward, tan(0.5 * c->fov_y), c->up));
    transform(m, v3_add(c->position, top), clip);
    check_near(clip[1] / clip[3], 1.0, 1e-12);
    rl_scene_clear(&s);
}

static void check_planes(const struct rl_scene *s)
{
    const struct rl_camera *c = &s->camera;
    assert_true(c->near_plane > 0.0 && c->near_plane >= 0.99e-3 * c->far_plane &&
                c->far_plane > c->near_plane);
    for (size_t i = 0; i < s->n_objects; i++)
        for (size_t k = 0; k < s->object[i].mesh.n_vertices; k++) {
            const float *p = s->object[i].mesh.position[k];
            double depth = v3_dot(v3_sub(v3(p[0], p[1], p[2]), c->position), c->forward);
            assert_true(depth < c->far_plane);
            assert_true(depth > c->near_plane || c->near_plane <= 1.01e-3 * c->far_plane);
        }
}

static void test_planes(void **state)
{
    (void)state;
    static const char *const positions[] = {
        "  position: [0, 1, 5]",
        "  position: [0, 0.1, 0.2]", /* inside the ball */
        "  position: [0, 1, -5000]",
        "  position: [0, 0.5, 1.001]",
    };
    for (size_t i = 0; i < sizeof positions / sizeof positions[0]; i++) {
        struct rl_scene s;
        load_with(&s, 3, 3, positions[i]);
        check_planes(&s);
        rl_scene_clear(&s);
    }
    struct rl_scene s;
    load_with(&s, 4, 4, "  target: [0, 1, 10]"); /* everything lies behind */
    assert_true(s.camera.near_plane > 0.0 && s.camera.far_plane > s.camera.near_plane);
    rl_scene_clear(&s);
    load_with(&s, 4, 6, "  target: [0, 1, 10]\n  field-of-view: 40\n  near: 50");
    assert_true(s.camera.near_plane == 50.0 && s.camera.far_plane > 50.0);
    rl_scene_clear(&s);
}

/* What no pixel shows leaves the planes where they are: behind the eye, beside the view, above it, far out to the side. A film that shows it
 * wants others. */
static void test_planes_of_what_is_seen(void **state)
{
    (void)state;
    static const char scene[] = "film: {width: 320, height: 240}\n"
                                "camera: {position: [0, 1.5, 5], target: [0, 0, 0], field-of-view: 40}\n"
                                "materials: [{name: m, ambient: [0.9, 0.1, 0.1]}]\n"
                                "objects: [{shape: plane, material: m}%s]\n";
    static const char *const unseen[] = {
        ", {shape: sphere, material: m, translate: [0, 0, 20]}",
        ", {shape: sphere, material: m, translate: [4.2, 1.5, 4]}",
        ", {shape: sphere, material: m, translate: [0, 5, 4.5]}",
        ", {shape: sphere, material: m, translate: [-90000, 0, -90000]}",
        ", {shape: sphere, material: m, scale: 12, translate: [0, 0, 20]}", /* not clear of the sides */
    };
    struct rl_scene s;
    char text[512];
    double near = 0.0, far = 0.0;
    for (size_t i = 0; i <= sizeof unseen / sizeof unseen[0]; i++) {
        int n = snprintf(text, sizeof text, scene, i ? unseen[i - 1] : "");
        put_file(path, text, (size_t)n);
        check_ok(rl_scene_load(&s, path, &error), &error);
        if (i == 0) {
            near = s.camera.near_plane;
            far = s.camera.far_plane;
            assert_true(near > 3.5 && near < 4.0 && far < 7.0);
        }
        check_near(s.camera.near_plane, near, 0.0);
        check_near(s.camera.far_plane, far, 0.0);
        /* A film so wide that it shows the ball beside the eye, and the one that is far out. */
        rl_scene_fit_planes(&s, 2400, 240);
        assert_true((s.camera.near_plane < 1.0) == (i == 2));
        assert_true((s.camera.far_plane > 8e4) == (i == 4));
        assert_true(i == 2 || i == 4 || (s.camera.near_plane == near && s.camera.far_plane == far));
        rl_scene_fit_planes(&s, s.width, s.height);
        check_near(s.camera.near_plane, near, 0.0);
        rl_scene_clear(&s);
    }
}

/* As the file says; the one that it does not give fits the objects. */
static void test_given_planes(void **state)
{
    (void)state;
    struct rl_scene s, fitting;
    load_with(&fitting, 0, -1, NULL);
    load_with(&s, 6, 6, "  field-of-view: 40\n  near: 0.25\n  far: 7.5");
    check_near(s.camera.near_plane, 0.25, 0.0);
    check_near(s.camera.far_plane, 7.5, 0.0);
    rl_scene_clear(&s);
    load_with(&s, 6, 6, "  field-of-view: 40\n  near: 1e-6");
    check_near(s.camera.near_plane, 1e-6, 0.0);
    check_near(s.camera.far_plane, fitting.camera.far_plane, 0.0);
    rl_scene_clear(&s);
    load_with(&s, 6, 6, "  field-of-view: 40\n  far: 5");
    check_near(s.camera.near_plane, fitting.camera.near_plane, 0.0);
    check_near(s.camera.far_plane, 5.0, 0.0);
    rl_scene_clear(&s);
    load_with(&s, 6, 6, "  field-of-view: 40\n  far: 1e9"); /* then the near one is not below a thousandth */
    check_near(s.camera.near_plane, 1e6, 1e-3);
    rl_scene_clear(&s);
    rl_scene_clear(&fitting);
}

static void test_visibility_settings(void **state)
{
    (void)state;
    struct rl_scene s;
    load_with(&s, 0, -1, NULL);
    assert_true(s.settings.culling && s.settings.depth_bits == 24 && !s.settings.reversed_depth);
    rl_scene_clear(&s);
    load_with(&s, 34, 35, "  culling: off\n  depth-bits: 32\n  reversed-depth: on");
    assert_true(!s.settings.culling && s.settings.depth_bits == 32 && s.settings.reversed_depth);
    rl_scene_clear(&s);
}

/* The scenes that come with the program. */
static void test_planes_of_scenes(void **state)
{
    (void)state;
    static const char *const scenes[] = {"studies/scenes/teapot-star.yaml", "studies/scenes/sphere-quad.yaml",
                                         "studies/scenes/two-roughness.yaml",
                                         "studies/scenes/three-lights.yaml"};
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        struct rl_scene s;
        check_ok(rl_scene_load(&s, scenes[i], &error), &error);
        check_planes(&s);
        rl_scene_clear(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_camera),
        cmocka_unit_test(test_planes),
        cmocka_unit_test(test_planes_of_what_is_seen),
        cmocka_unit_test(test_planes_of_scenes),
        cmocka_unit_test(test_given_planes),
        cmocka_unit_test(test_visibility_settings),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
