/* The CPU renderer: what a pixel is, which faces are seen, and that threads make no difference. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reference/fixture.h"
#include "reference/renderer.h"
#include "support/check.h"

enum { WIDTH = 33, HEIGHT = 21 };

/* A square [-1, 1]^2 at height z, facing +z or -z, its normals along (0, 0, n_z). */
static void add_square(struct rl_scene *scene, float z, bool up, float n_z, int material)
{
    static const float corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const uint32_t triangle[2][2][3] = {{{0, 2, 1}, {0, 3, 2}}, {{0, 1, 2}, {0, 2, 3}}};
    struct rl_object *object = &scene->object[scene->n_objects++];
    struct rl_error error;
    check_ok(rl_mesh_allocate(&object->mesh, 4, 2, &error), &error);
    for (int i = 0; i < 4; i++) {
        memcpy(object->mesh.position[i], (const float[3]){corner[i][0], corner[i][1], z}, sizeof(float[3]));
        memcpy(object->mesh.normal[i], (const float[3]){0, 0, n_z}, sizeof(float[3]));
    }
    memcpy(object->mesh.triangle, triangle[up], sizeof triangle[up]);
    object->material = material;
    object->centre = v3(0, 0, z);
    object->radius = 2.0;
}

struct world {
    struct rl_scene scene;
    struct rl_object object[4];
    struct rl_material material[2];
    struct rl_light light;
    struct rl_polygon polygon;
    rl_vec3 vertex[4];
    struct rl_settings settings;
    struct rl_plan plan;
};

static double ambient_of(const struct world *w, int c)
{
    return rl_effect_given(&w->material[0], rl_effect_find("ambient"))[c];
}

/* The eye at (0, -3, 3) looks at the origin; a light above and behind, of radiance (2, 1, 0.5), mirrored in the square at z = 0. */
static void world_make(struct world *w, const char *method)
{
    struct rl_error error;
    memset(w, 0, sizeof *w);
    w->material[0] =
        (struct rl_material){.name = "lacquer", .rr = 20.0, .specular = {1.0, 0.5, 0.25}, .method = method};
    w->material[1] = (struct rl_material){.name = "matt", .rr = 5.0};
    rl_effect_give_colour(&w->material[0], "ambient", 0.1, 0.2, 0.3);
    rl_effect_give_colour(&w->material[1], "ambient", 0.5, 0.5, 0.5);
    const rl_vec3 vertex[4] = {{-1, 2, 2}, {1, 2, 2}, {1, 3, 4}, {-1, 3, 4}};
    memcpy(w->vertex, vertex, sizeof vertex);
    check_ok(rl_polygon_make(&w->polygon, w->vertex, 4, &error), &error);
    w->light = (struct rl_light){.name = "window",
                                 .n_polygons = 1,
                                 .polygon = &w->polygon,
                                 .radiance = {2.0, 1.0, 0.5},
                                 .centroid = v3(0, 2.5, 3),
                                 .centre = v3(0, 2.5, 3),
                                 .radius = 2.0,
                                 .area = w->polygon.area};
    double half = sqrt(0.5);
    w->scene = (struct rl_scene){
        .width = WIDTH,
        .height = HEIGHT,
        .camera = {v3(0, -3, 3), v3(1, 0, 0), v3(0, half, half), v3(0, half, -half), 0.6, 0.1, 20.0, false,
                   false},
        .n_materials = 2,
        .n_lights = 1,
        .material = w->material,
        .object = w->object,
        .light = &w->light,
        .settings = RL_SETTINGS_DEFAULT,
    };
    w->settings = RL_SETTINGS_DEFAULT;
    w->settings.tolerance = 1e-8;
}

static void world_plan(struct world *w)
{
    struct rl_error error;
    check_ok(rl_plan_make(&w->plan, &w->scene, &w->settings, &error), &error);
}

static void world_clear(struct world *w)
{
    rl_plan_clear(&w->plan);
    rl_polygon_clear(&w->polygon);
    for (size_t i = 0; i < w->scene.n_objects; i++)
        rl_mesh_clear(&w->object[i].mesh);
}

static void render(struct rl_image *image, struct rl_render_stats *stats, const struct world *w, int threads)
{
    struct rl_error error;
    memset(image, 0, sizeof *image);
    check_ok(rl_reference_render(image, stats, &w->scene, &w->plan, threads, NULL, &error), &error);
}

/* The point of the plane z = 0 that a pixel's centre shows, or false. */
static bool point_on_square(struct rl_surface *s, const struct world *w, int x, int y)
{
    rl_vec3 eye = w->scene.camera.position, ray = rl_camera_ray(&w->scene.camera, WIDTH, HEIGHT, x, y);
    double t = -eye.z / ray.z;
    *s = (struct rl_surface){v3_madd(eye, t, ray), v3(0, 0, 1), v3_scale(-1.0, ray)};
    return t > 0.0 && fabs(s->P.x) < 1.0 && fabs(s->P.y) < 1.0;
}

static void test_pixels(void **state)
{
    (void)state;
    struct world w;
    world_make(&w, "reference");
    add_square(&w.scene, 0.0f, true, 1.0f, 0);
    world_plan(&w);
    struct rl_image image;
    struct rl_render_stats stats;
    render(&image, &stats, &w, 2);
    struct rl_light_set *set;
    check_ok(rl_light_set_make(&set, &w.light, 1, NULL), &(struct rl_error){.message = ""});
    size_t foreground = 0;
    double brightest = 0.0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *pixel = rl_image_pixel(&image, x, y);
            struct rl_surface s;
            if (!point_on_square(&s, &w, x, y)) {
                assert_true(pixel[0] == 0.0f && pixel[1] == 0.0f && pixel[2] == 0.0f && pixel[3] == 0.0f);
                continue;
            }
            struct rl_estimate r = integrate(&s, 20.0, set, true, 1e-8);
            foreground++;
            brightest = fmax(brightest, r.value[0]);
            for (int c = 0; c < 3; c++)
                check_near(pixel[c], ambient_of(&w, c) + w.material[0].specular[c] * r.value[c], 2e-7);
            assert_true(pixel[3] == 1.0f);
        }
    print_message("%zu pixels, brightest highlight %g\n", foreground, brightest);
    assert_true(foreground > 100 && brightest > 1.0);
    assert_int_equal(stats.foreground, foreground);
    assert_int_equal(stats.unconverged, 0);
    assert_int_equal(stats.threads, 2);
    assert_true(stats.evaluations > foreground && stats.seconds > 0.0);
    assert_true(stats.worst_error > 0.0 && stats.worst_error <= 2e-8);
    rl_light_set_free(set);
    rl_image_clear(&image);
    world_clear(&w);
}

/* Every pixel by every texel: the same whatever the threads, near to the reference that sees the light from the object's centre, and
 * not near to the one that sees it from the pixel's own point. */
static void test_exhaustive(void **state)
{
    (void)state;
    struct rl_image image[4];
    struct rl_render_stats stats[4];
    static const struct {
        const char *method;
        enum rl_light_from from;
        int threads;
    } rows[4] = {{"exhaustive", RL_LIGHT_FROM_POINT, 1},
                 {"exhaustive", RL_LIGHT_FROM_OBJECT, 3},
                 {"reference", RL_LIGHT_FROM_OBJECT, 2},
                 {"reference", RL_LIGHT_FROM_POINT, 2}};
    for (int i = 0; i < 4; i++) {
        struct world w;
        world_make(&w, rows[i].method);
        add_square(&w.scene, 0.0f, true, 1.0f, 0);
        w.settings.light_from = rows[i].from;
        w.settings.env_size = 400;
        world_plan(&w);
        render(&image[i], &stats[i], &w, rows[i].threads);
        world_clear(&w);
    }
    assert_memory_equal(image[0].data, image[1].data, sizeof(float) * 4 * WIDTH * HEIGHT);
    assert_true(stats[0].texels == stats[1].texels && stats[0].texels > 1000 * stats[0].foreground);
    assert_true(stats[0].evaluations == 0 && stats[0].worst_error == 0.0 && stats[2].texels == 0);
    double from_centre = 0.0, from_point = 0.0;
    for (size_t i = 0; i < (size_t)4 * WIDTH * HEIGHT; i++) {
        from_centre += (double)fabsf(image[0].data[i] - image[2].data[i]) / (double)(3 * stats[0].foreground);
        from_point += (double)fabsf(image[0].data[i] - image[3].data[i]) / (double)(3 * stats[0].foreground);
    }
    print_message("off by %.1e on the average; by parallax %.1e\n", from_centre, from_point);
    assert_true(from_centre < 2e-3 && from_point > 0.05);
    for (int i = 0; i < 4; i++)
        rl_image_clear(&image[i]);
}

/* A square in front that faces away is not there; one that faces the eye hides what is behind. */
static void test_back_faces(void **state)
{
    (void)state;
    for (int facing = 0; facing < 2; facing++) {
        struct world w;
        world_make(&w, NULL);
        add_square(&w.scene, 0.0f, true, 1.0f, 0);
        add_square(&w.scene, 0.5f, facing, 1.0f, 1);
        world_plan(&w);
        struct rl_image image;
        struct rl_render_stats stats;
        render(&image, &stats, &w, 1);
        const float *middle = rl_image_pixel(&image, WIDTH / 2, HEIGHT / 2);
        check_near(middle[2], facing ? 0.5 : 0.3, 1e-7);
        rl_image_clear(&image);
        world_clear(&w);
    }
}

/* A shading normal that faces away from the eye takes the highlight, not the pixel. */
static void test_normal_away(void **state)
{
    (void)state;
    struct world w;
    world_make(&w, "reference");
    add_square(&w.scene, 0.0f, true, -1.0f, 0);
    world_plan(&w);
    struct rl_image image;
    struct rl_render_stats stats;
    render(&image, &stats, &w, 1);
    const float *middle = rl_image_pixel(&image, WIDTH / 2, HEIGHT / 2);
    check_near(middle[0], 0.1, 1e-7);
    assert_true(middle[3] == 1.0f);
    assert_int_equal(stats.evaluations, 0);
    rl_image_clear(&image);
    world_clear(&w);
}

static void test_plain(void **state)
{
    (void)state;
    struct world w;
    world_make(&w, "plain");
    add_square(&w.scene, 0.0f, true, 1.0f, 0);
    world_plan(&w);
    struct rl_image image;
    struct rl_render_stats stats;
    render(&image, &stats, &w, 1);
    assert_int_equal(stats.evaluations, 0);
    struct rl_surface s;
    assert_true(point_on_square(&s, &w, WIDTH / 2, HEIGHT / 2));
    struct rl_ellipsoid e = rl_ellipsoid_make(20.0);
    const struct rl_method *plain = rl_method_find("plain");
    const struct rl_point_light light = rl_light_as_point(&w.light);
    double params[RL_EFFECT_PARAMS][4], rgb[3];
    plain->pack(&e, params);
    plain->shade(&s, &light, 1, params, rgb);
    for (int c = 0; c < 3; c++)
        check_near(rl_image_pixel(&image, WIDTH / 2, HEIGHT / 2)[c],
                   ambient_of(&w, c) + w.material[0].specular[c] * rgb[c], 1e-6);
    rl_image_clear(&image);
    world_clear(&w);
}

static void test_threads(void **state)
{
    (void)state;
    struct world w;
    world_make(&w, "reference");
    add_square(&w.scene, 0.0f, true, 1.0f, 0);
    world_plan(&w);
    struct rl_image one;
    struct rl_render_stats stats_one;
    render(&one, &stats_one, &w, 1);
    for (int threads = 0; threads < 5; threads += 2) {
        struct rl_image image;
        struct rl_render_stats stats;
        render(&image, &stats, &w, threads);
        assert_memory_equal(image.data, one.data, sizeof(float) * 4 * WIDTH * HEIGHT);
        assert_int_equal(stats.evaluations, stats_one.evaluations);
        assert_true(stats.worst_error == stats_one.worst_error);
        assert_true(threads > 0 ? stats.threads == threads : stats.threads >= 1);
        rl_image_clear(&image);
    }
    rl_image_clear(&one);
    world_clear(&w);
}

struct watch {
    size_t updates, last, total, stop_after;
};

static void on_update(void *user, const char *what, size_t done, size_t total)
{
    struct watch *watch = user;
    assert_non_null(what);
    assert_true(done == watch->last + 1 && done <= total);
    watch->updates++;
    watch->last = done;
    watch->total = total;
}

static bool on_cancelled(void *user)
{
    const struct watch *watch = user;
    return watch->updates >= watch->stop_after;
}

static void test_progress_and_interruption(void **state)
{
    (void)state;
    struct world w;
    world_make(&w, "reference");
    add_square(&w.scene, 0.0f, true, 1.0f, 0);
    world_plan(&w);
    struct watch watch = {.stop_after = 1000};
    const struct rl_progress progress = {.update = on_update, .cancelled = on_cancelled, .user = &watch};
    struct rl_image image = {0};
    struct rl_render_stats stats;
    struct rl_error error;
    check_ok(rl_reference_render(&image, &stats, &w.scene, &w.plan, 1, &progress, &error), &error);
    assert_true(watch.updates == watch.total && watch.total > 1);
    rl_image_clear(&image);

    watch = (struct watch){.stop_after = 2};
    int status = rl_reference_render(&image, &stats, &w.scene, &w.plan, 1, &progress, &error);
    check_fails(status, &error, RL_ERR_CANCELLED, "interrupted");
    assert_int_equal(watch.updates, 2);
    assert_null(image.data);
    world_clear(&w);
}

/* An infinite radiance must not get into an image unnoticed. */
static void test_nonfinite(void **state)
{
    (void)state;
    struct world w;
    world_make(&w, "reference");
    w.light.radiance[1] = INFINITY;
    add_square(&w.scene, 0.0f, true, 1.0f, 0);
    world_plan(&w);
    struct rl_image image = {0};
    struct rl_render_stats stats;
    struct rl_error error;
    int status = rl_reference_render(&image, &stats, &w.scene, &w.plan, 1, NULL, &error);
    check_fails(status, &error, RL_ERR_CHECK, "finite");
    assert_null(image.data);
    world_clear(&w);
}

/* Real meshes through a scene file: a closed surface shows no gap, and a finer tolerance the same picture. */
static void test_scene_file(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_error error;
    check_ok(rl_scene_load(&scene, "studies/scenes/sphere-quad.yaml", &error), &error);
    struct rl_settings settings = scene.settings;
    settings.method = "reference";
    settings.width = 64;
    settings.height = 48;
    float *coarse = NULL;
    for (int i = 0; i < 2; i++) {
        struct rl_plan plan;
        struct rl_image image = {0};
        struct rl_render_stats stats;
        settings.tolerance = i ? 1e-9 : 1e-4;
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        check_ok(rl_reference_render(&image, &stats, &scene, &plan, 0, NULL, &error), &error);
        assert_int_equal(stats.unconverged, 0);
        assert_true(stats.foreground > 64 * 48 / 10);
        if (coarse)
            for (size_t j = 0; j < (size_t)64 * 48 * 4; j++)
                check_near(image.data[j], coarse[j], 1e-4);
        free(coarse);
        coarse = image.data;
        image.data = NULL;
        rl_image_clear(&image);
        rl_plan_clear(&plan);
    }
    free(coarse);
    rl_scene_clear(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels),
        cmocka_unit_test(test_exhaustive),
        cmocka_unit_test(test_back_faces),
        cmocka_unit_test(test_normal_away),
        cmocka_unit_test(test_plain),
        cmocka_unit_test(test_threads),
        cmocka_unit_test(test_progress_and_interruption),
        cmocka_unit_test(test_nonfinite),
        cmocka_unit_test(test_scene_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
