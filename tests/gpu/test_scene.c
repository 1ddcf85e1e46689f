/* Pictures: orientation, what hides what, repeatability, finite values, and errors for what cannot be drawn.
 * */
#include <stdbool.h>

#include "gpu/fixture.h"

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

/* No sample count, ratio, grazing view or near light makes a NaN or an infinity. */
static void every_pixel_is_finite(void **state)
{
    (void)state;
    static const int counts[] = {1, 2, 3, 4, 5, 13, 64, 1024};
    static const double ratios[] = {1e-6, 0.5, 1.0, 30.0, 1e6, 1e12};
    static const char *const methods[] = {"plain", "regular", "random"};
    for (size_t m = 0; m < 3; m++)
        for (size_t n = 0; n < sizeof counts / sizeof counts[0]; n++)
            for (size_t r = 0; r < sizeof ratios / sizeof ratios[0]; r++) {
                if (counts[n] > 64 && r % 2 == 0)
                    continue;
                struct rl_scene scene;
                struct rl_image image;
                struct rl_settings settings = RL_SETTINGS_DEFAULT;
                settings.samples = counts[n];
                settings.normal_bits = n % 2 ? 8 : RL_NORMAL_BITS_FLOAT;
                settings.normal_size = 64;
                settings.frame = n % 3 ? RL_FRAME_ORTHONORMAL : RL_FRAME_PRINTED;
                settings.attenuation = n != 3;
                settings.margin_kind = RL_MARGIN_VALUE;
                settings.margin = 1.0;
                fixture_begin(&scene, 32, 24);
                fixture_camera(&scene, v3(0.0, 0.001, 2.0), v3(0.0, 0.0, 0.0), 60.0);
                int material = fixture_material(&scene, ratios[r], 0.1, 0.5, 1.0, methods[m]);
                fixture_object(&scene, RL_SHAPE_PLANE, 1, 2.0, v3(0.0, 0.0, 0.0), material);
                fixture_object(&scene, RL_SHAPE_SPHERE, 8, 0.5, v3(0.0, 0.5, 0.0), material);
                fixture_quad(&scene, v3(0.0, 0.5, 0.0), v3(1.0, 0.0, 0.0), v3(0.0, 0.0, 1.0), 1.0, 2.0, 3.0);
                fixture_quad(&scene, v3(0.0, 0.0, -1.0), v3(1.0, 0.0, 0.0), v3(0.0, 1.0, 0.0), 3.0, 0.0, 1.0);
                fixture_render(&image, gpu, &scene, &settings);
                for (int i = 0; i < 4 * image.width * image.height; i++)
                    if (!isfinite(image.data[i]) || image.data[i] < 0.0f)
                        fail_msg("%s, %d samples, R_r %g: value %g", methods[m], counts[n], ratios[r],
                                 image.data[i]);
                rl_image_clear(&image);
                fixture_end(&scene);
            }
}

/* Bright top left, dim bottom right; the camera looks along -z, x to the right. */
static void row_0_is_the_top(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_image image;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    fixture_begin(&scene, 40, 30);
    fixture_camera(&scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 40.0);
    fixture_object(&scene, RL_SHAPE_SPHERE, 8, 0.3, v3(-1.0, 0.8, 0.0),
                   fixture_material(&scene, 10.0, 1.0, 0.0, 0.0, NULL));
    fixture_object(&scene, RL_SHAPE_SPHERE, 8, 0.3, v3(1.0, -0.8, 0.0),
                   fixture_material(&scene, 10.0, 0.25, 0.0, 0.0, NULL));
    fixture_render(&image, gpu, &scene, &settings);
    const float *top_left = rl_image_pixel(&image, 10, 7);
    const float *bottom_right = rl_image_pixel(&image, 30, 22);
    assert_true(top_left[0] == 1.0f && top_left[1] == 0.8f && top_left[3] == 1.0f);
    assert_true(bottom_right[0] == 0.25f && bottom_right[3] == 1.0f);
    assert_true(rl_image_pixel(&image, 10, 22)[3] == 0.0f && rl_image_pixel(&image, 30, 7)[3] == 0.0f);
    rl_image_clear(&image);
    fixture_end(&scene);
}

/* The nearer object shows, whichever comes first in the scene; and nothing is added for the highlight of the
 * hidden one, which is bright at that very pixel when it is alone. */
static void an_object_behind_another_is_hidden(void **state)
{
    (void)state;
    for (int order = 0; order < 3; order++) {
        struct rl_scene scene;
        struct rl_image image;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.attenuation = false;
        settings.env_size = 16;
        fixture_furnace(&scene, "regular", 2.0);
        rl_mesh_clear(&scene.object[0].mesh);
        scene.n_objects = 0;
        int near_material = fixture_material(&scene, 10.0, 0.5, 0.0, 0.0, NULL);
        for (int i = 0; i < 2; i++)
            if (i == order)
                fixture_object(&scene, RL_SHAPE_SPHERE, 12, 0.2, v3(0.0, 0.0, 1.0), near_material);
            else if (order < 2)
                fixture_object(&scene, RL_SHAPE_SPHERE, 12, 0.9, v3(0.0, 0.0, -1.0), 0);
            else if (i == 0)
                fixture_object(&scene, RL_SHAPE_SPHERE, 12, 0.2, v3(0.0, 0.0, 1.0), 0);
        fixture_render(&image, gpu, &scene, &settings);
        check_near(rl_image_pixel(&image, 24, 18)[0], order == 2 ? 1.0 : 0.5, 1e-6);
        if (order < 2)
            check_near(rl_image_pixel(&image, 24, 10)[0], 1.0, 1e-6);
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

/* A triangle that a mesh has twice, and an object that a scene has twice, shine once. */
static void coincident_surfaces_shine_once(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; kind++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_image image;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.attenuation = false;
        settings.env_size = 16;
        settings.margin_kind = kind % 2 ? RL_MARGIN_VALUE : RL_MARGIN_OFF;
        settings.margin = 1.0;
        fixture_furnace(&scene, "regular", 2.0);
        if (kind < 2) {
            fixture_object(&scene, RL_SHAPE_SPHERE, 24, 1.0, v3(0.0, 0.0, 0.0), 0);
        } else {
            struct rl_mesh *mesh = &scene.object[0].mesh;
            struct rl_mesh twice;
            size_t n = mesh->n_triangles;
            check_ok(rl_mesh_allocate(&twice, mesh->n_vertices, 2 * n, &error), &error);
            memcpy(twice.position, mesh->position, mesh->n_vertices * sizeof *mesh->position);
            memcpy(twice.normal, mesh->normal, mesh->n_vertices * sizeof *mesh->normal);
            memcpy(twice.triangle, mesh->triangle, n * sizeof *mesh->triangle);
            memcpy(twice.triangle + n, mesh->triangle, n * sizeof *mesh->triangle);
            rl_mesh_clear(mesh);
            *mesh = twice;
        }
        fixture_render(&image, gpu, &scene, &settings);
        check_near(rl_image_pixel(&image, 24, 18)[0], 1.0, 1e-6);
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

/* A plane is there from above and not from below. */
static void back_faces_are_not_drawn(void **state)
{
    (void)state;
    for (int below = 0; below < 2; below++) {
        struct rl_scene scene;
        struct rl_image image;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        fixture_begin(&scene, 16, 16);
        fixture_camera(&scene, v3(0.0, below ? -3.0 : 3.0, 0.1), v3(0.0, 0.0, 0.0), 20.0);
        fixture_object(&scene, RL_SHAPE_PLANE, 2, 1.0, v3(0.0, 0.0, 0.0),
                       fixture_material(&scene, 10.0, 1.0, 0.0, 0.0, NULL));
        fixture_render(&image, gpu, &scene, &settings);
        assert_true(rl_image_pixel(&image, 8, 8)[3] == (below ? 0.0f : 1.0f));
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

/* Normals that face away from the eye, as interpolation makes at silhouettes, here everywhere: no highlight,
 * though light comes from all round and nothing attenuates it. */
static void normals_that_face_away_have_no_highlight(void **state)
{
    (void)state;
    static const char *const methods[] = {"plain", "regular", "random"};
    for (size_t m = 0; m < 3; m++)
        for (int away = 0; away < 2; away++) {
            struct rl_scene scene;
            struct rl_image image;
            struct rl_settings settings = RL_SETTINGS_DEFAULT;
            settings.attenuation = false;
            settings.env_size = 16;
            fixture_furnace(&scene, methods[m], 1.0);
            for (size_t i = 0; away && i < scene.object[0].mesh.n_vertices; i++)
                for (int c = 0; c < 3; c++)
                    scene.object[0].mesh.normal[i][c] *= -1.0f;
            fixture_render(&image, gpu, &scene, &settings);
            const float *centre = rl_image_pixel(&image, 24, 18);
            assert_true(centre[3] == 1.0f && (away || centre[0] > 0.5f));
            for (int i = 0; away && i < 48 * 36; i++)
                assert_true(image.data[4 * (size_t)i] == 0.0f);
            rl_image_clear(&image);
            fixture_end(&scene);
        }
}

/* Drawing again changes nothing; another seed does; and so does nothing that was drawn in between. */
static void frames_repeat(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan[2];
    struct rl_gpu_scene *gs[2];
    struct rl_image image[3];
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    double seconds;
    fixture_sphere(&scene, 64, 48, "random", 5.0);
    for (int i = 0; i < 2; i++) {
        settings.seed = (uint64_t)i + 1;
        settings.env_size = i ? 64 : 256;
        check_ok(rl_plan_make(&plan[i], &scene, &settings, &error), &error);
        check_ok(rl_gpu_scene_make(&gs[i], gpu, &scene, &plan[i], &error), &error);
    }
    for (int i = 0; i < 3; i++) {
        check_ok(rl_gpu_scene_frame(gs[i % 2], &seconds, &error), &error);
        assert_true(seconds > 0.0 && seconds < 60.0);
        check_ok(rl_gpu_scene_read(gs[i % 2], &image[i], &error), &error);
    }
    assert_memory_equal(image[0].data, image[2].data, sizeof(float) * 4 * 64 * 48);
    assert_memory_not_equal(image[0].data, image[1].data, sizeof(float) * 4 * 64 * 48);
    struct rl_gpu_counters counters = rl_gpu_scene_counters(gs[0]);
    assert_int_equal(counters.programs, 3);
    assert_int_equal(counters.textures, 2);
    assert_int_equal(counters.draws, 6 + 2 * 2);
    assert_true(counters.bytes_uploaded > (size_t)512 * 512 * 4);
    rl_gpu_scene_reset_counters(gs[0]);
    assert_int_equal(rl_gpu_scene_counters(gs[0]).triangles, 0);
    for (int i = 0; i < 2; i++) {
        rl_gpu_scene_free(gs[i]);
        rl_plan_clear(&plan[i]);
    }
    for (int i = 0; i < 3; i++)
        rl_image_clear(&image[i]);
    fixture_end(&scene);
}

/* A scene that is given another seed draws what one made with that seed draws, and back; in between it is not the same. */
static void reseeding_is_making_anew(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan[2];
    struct rl_gpu_scene *gs[2];
    struct rl_image image[4];
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    double seconds;
    fixture_sphere(&scene, 64, 48, "random", 5.0);
    for (int i = 0; i < 2; i++) {
        settings.seed = (uint64_t)i + 1;
        check_ok(rl_plan_make(&plan[i], &scene, &settings, &error), &error);
        check_ok(rl_gpu_scene_make(&gs[i], gpu, &scene, &plan[i], &error), &error);
    }
    /* Made with 1, made with 2, reseeded to 2, back to 1. */
    for (int i = 0; i < 4; i++) {
        struct rl_gpu_scene *which = gs[i == 1];
        if (i >= 2)
            check_ok(rl_gpu_scene_reseed(which, i == 2 ? 2 : 1, &error), &error);
        check_ok(rl_gpu_scene_frame(which, &seconds, &error), &error);
        check_ok(rl_gpu_scene_read(which, &image[i], &error), &error);
    }
    size_t bytes = sizeof(float) * 4 * 64 * 48;
    assert_memory_not_equal(image[0].data, image[1].data, bytes);
    assert_memory_equal(image[2].data, image[1].data, bytes);
    assert_memory_equal(image[3].data, image[0].data, bytes);
    for (int i = 0; i < 2; i++) {
        rl_gpu_scene_free(gs[i]);
        rl_plan_clear(&plan[i]);
    }
    for (int i = 0; i < 4; i++)
        rl_image_clear(&image[i]);
    fixture_end(&scene);
}

static void an_image_that_opengl_refuses_is_an_error(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    fixture_sphere(&scene, 64, 48, "random", 5.0);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    plan.settings.width = 1 << 20;
    check_fails(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error, RL_ERR_UNAVAILABLE,
                "image of 1048576 x 48 pixels");
    assert_null(gs);
    /* Each side is allowed, the whole is not. */
    plan.settings.width = plan.settings.height = 16384;
    check_fails(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error, RL_ERR_SYSTEM,
                "image of 16384 x 16384 pixels");
    plan.on_cpu = true;
    check_fails(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error, RL_ERR_INPUT, "CPU");
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_is_finite),
        cmocka_unit_test(row_0_is_the_top),
        cmocka_unit_test(an_object_behind_another_is_hidden),
        cmocka_unit_test(coincident_surfaces_shine_once),
        cmocka_unit_test(back_faces_are_not_drawn),
        cmocka_unit_test(normals_that_face_away_have_no_highlight),
        cmocka_unit_test(frames_repeat),
        cmocka_unit_test(reseeding_is_making_anew),
        cmocka_unit_test(an_image_that_opengl_refuses_is_an_error),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
