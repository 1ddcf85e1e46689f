/* The sphere pass: what it may take away, and what it must not. */
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

static bool same_pixel(const struct rl_image *a, const struct rl_image *b, int x, int y)
{
    const float *p = rl_image_pixel(a, x, y);
    const float *q = rl_image_pixel(b, x, y);
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2] && p[3] == q[3];
}

/* margin < 0: no sphere pass. */
static void render(struct rl_image *image, const struct rl_scene *scene, double margin)
{
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    settings.margin_kind = margin < 0.0 ? RL_MARGIN_OFF : RL_MARGIN_VALUE;
    settings.margin = fmax(0.0, margin);
    fixture_render(image, gpu, scene, &settings);
}

/* The bits are the same wherever the pass lets a pixel through: its highlight is drawn by the same shader. */
static void a_huge_margin_changes_nothing(void **state)
{
    (void)state;
    static const char *const methods[] = {"random", "regular"};
    for (size_t m = 0; m < 2; m++) {
        struct rl_scene scene;
        struct rl_image without;
        struct rl_image with;
        fixture_sphere(&scene, 80, 60, methods[m], 3.0);
        render(&without, &scene, -1.0);
        render(&with, &scene, 1e6);
        assert_memory_equal(without.data, with.data, sizeof(float) * 4 * 80 * 60);
        rl_image_clear(&without);
        rl_image_clear(&with);
        fixture_end(&scene);
    }
}

/* Each margin's picture is that without spheres but for pixels that have lost their highlight, fewer and
 * fewer of them. */
static void a_margin_only_removes(void **state)
{
    (void)state;
    static const double margins[] = {0.0, 0.25, 1.0, 3.0};
    struct rl_scene scene;
    struct rl_image without;
    struct rl_image bare;
    fixture_sphere(&scene, 160, 120, "random", 10.0);
    render(&without, &scene, -1.0);
    scene.material[0].specular[0] = scene.material[0].specular[1] = scene.material[0].specular[2] = 0.0;
    render(&bare, &scene, -1.0);
    for (int c = 0; c < 3; c++)
        scene.material[0].specular[c] = 1.0;
    size_t before = SIZE_MAX;
    for (size_t m = 0; m < sizeof margins / sizeof margins[0]; m++) {
        struct rl_image with;
        size_t removed = 0;
        size_t kept = 0;
        render(&with, &scene, margins[m]);
        for (int y = 0; y < 120; y++)
            for (int x = 0; x < 160; x++) {
                bool same = same_pixel(&with, &without, x, y);
                bool dark = same_pixel(&with, &bare, x, y);
                assert_true(same || dark);
                removed += !same;
                kept += same && !dark;
            }
        print_message("margin %g: %zu pixels removed, %zu kept\n", margins[m], removed, kept);
        assert_true(removed < before);
        assert_true(kept > 100);
        before = removed;
        rl_image_clear(&with);
    }
    rl_image_clear(&without);
    rl_image_clear(&bare);
    fixture_end(&scene);
}

static bool meets_sphere(rl_vec3 from, rl_vec3 direction, rl_vec3 centre, double radius)
{
    rl_vec3 d = v3_sub(centre, from);
    double along = v3_dot(d, direction);
    double distance = v3_length(d);
    if (distance <= radius)
        return true;
    return along > 0.0 && distance * distance - along * along <= radius * radius;
}

/* A plane seen from above: the pixels that keep their highlight are those whose mirror direction, drawn from the plane's
 * centre as the environment map sees it, meets a sphere, by a test written in another way. */
static void the_pass_is_the_ray_and_sphere_test(void **state)
{
    (void)state;
    static const double margins[] = {0.0, 0.5, 2.0};
    for (size_t m = 0; m < sizeof margins / sizeof margins[0]; m++) {
        struct rl_scene scene;
        struct rl_image image;
        struct rl_image without;
        fixture_begin(&scene, 64, 48);
        fixture_camera(&scene, v3(0.0, 2.0, 3.0), v3(0.0, 0.0, 0.0), 50.0);
        fixture_object(&scene, RL_SHAPE_PLANE, 1, 4.0, v3(0.0, 0.0, 0.0),
                       fixture_material(&scene, 1.0, 0.0, 0.0, 1.0, "regular"));
        fixture_quad(&scene, v3(-0.5, 1.5, -2.0), v3(0.3, 0.0, 0.0), v3(0.0, 0.3, 0.0), 1.0, 1.0, 1.0);
        fixture_quad(&scene, v3(1.0, 0.3, 0.5), v3(0.2, 0.0, 0.0), v3(0.0, 0.1, 0.2), 1.0, 1.0, 1.0);
        render(&image, &scene, margins[m]);
        render(&without, &scene, -1.0);
        size_t wrong = 0;
        size_t inside = 0;
        for (int y = 0; y < 48; y++)
            for (int x = 0; x < 64; x++) {
                rl_vec3 direction = rl_camera_ray(&scene.camera, 64, 48, x, y);
                double t = -scene.camera.position.y / direction.y;
                rl_vec3 P = v3_madd(scene.camera.position, t, direction);
                if (!(t > 0.0) || fabs(P.x) > 3.9 || fabs(P.z) > 3.9 ||
                    rl_image_pixel(&without, x, y)[0] == 0.0f)
                    continue;
                bool hit = false;
                for (size_t i = 0; i < scene.n_lights; i++)
                    hit = hit ||
                          meets_sphere(scene.object[0].centre, v3(direction.x, -direction.y, direction.z),
                                       scene.light[i].centre, (1.0 + margins[m]) * scene.light[i].radius);
                wrong += hit != (rl_image_pixel(&image, x, y)[0] > 0.0f);
                inside += hit;
            }
        print_message("margin %g: %zu pixels inside, %zu wrong\n", margins[m], inside, wrong);
        assert_true(inside > 20);
        assert_in_range(wrong, 0, 1);
        rl_image_clear(&image);
        rl_image_clear(&without);
        fixture_end(&scene);
    }
}

/* The stencil of one object does not let another's highlight through, and an object without spheres is not
 * masked. */
static void spheres_are_by_material(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    struct rl_image image;
    struct rl_image without;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    double seconds;
    fixture_begin(&scene, 160, 80);
    fixture_camera(&scene, v3(0.0, 0.0, 6.0), v3(0.0, 0.0, 0.0), 25.0);
    for (int i = 0; i < 2; i++)
        fixture_object(&scene, RL_SHAPE_SPHERE, 16, 1.0, v3(i ? 1.1 : -1.1, 0.0, 0.0),
                       fixture_material(&scene, 3.0, 0.0, 0.0, 1.0, "random"));
    fixture_quad(&scene, v3(0.0, 3.0, 3.0), v3(0.5, 0.0, 0.0), v3(0.0, 0.5, -0.5), 1.0, 1.0, 1.0);
    fixture_render(&without, gpu, &scene, &settings);
    settings.margin_kind = RL_MARGIN_VALUE;
    settings.margin = 0.0;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    plan.material[1].sphere_program = -1;
    check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(gs, &image, &error), &error);
    size_t left = 0;
    for (int y = 0; y < 80; y++)
        for (int x = 0; x < 160; x++) {
            bool same = same_pixel(&image, &without, x, y);
            assert_true(same || x < 80);
            left += !same;
        }
    print_message("%zu pixels of the first object are masked\n", left);
    assert_true(left > 10);
    rl_image_clear(&image);
    rl_image_clear(&without);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

/* Where the highlight pass drew: all of the sphere without a margin, with one the pixels that keep their highlight. */
static void what_was_drawn_is_known(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_image picture[2], drawn[2];
    fixture_sphere(&scene, 80, 60, "random", 3.0);
    for (int i = 0; i < 2; i++) {
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        struct rl_plan plan;
        struct rl_gpu_scene *gs;
        double seconds;
        settings.margin_kind = i ? RL_MARGIN_VALUE : RL_MARGIN_OFF;
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
        check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
        check_ok(rl_gpu_scene_read(gs, &picture[i], &error), &error);
        check_ok(rl_gpu_scene_read_drawn(gs, &drawn[i], &error), &error);
        rl_gpu_scene_free(gs);
        rl_plan_clear(&plan);
    }
    size_t count[2] = {0, 0};
    for (int y = 0; y < 60; y++)
        for (int x = 0; x < 80; x++) {
            bool covered = rl_image_pixel(&picture[0], x, y)[3] > 0.5f;
            bool on[2] = {rl_image_pixel(&drawn[0], x, y)[0] == 1.0f,
                          rl_image_pixel(&drawn[1], x, y)[0] == 1.0f};
            assert_true(on[0] == covered);
            assert_true(!on[1] || same_pixel(&picture[0], &picture[1], x, y));
            assert_true(on[1] || same_pixel(&picture[0], &picture[1], x, y) ||
                        rl_image_pixel(&picture[1], x, y)[0] < rl_image_pixel(&picture[0], x, y)[0]);
            count[0] += on[0];
            count[1] += on[1];
        }
    assert_true(count[1] > 50 && count[1] < count[0] - 50);
    for (int i = 0; i < 2; i++) {
        rl_image_clear(&picture[i]);
        rl_image_clear(&drawn[i]);
    }
    fixture_end(&scene);
}

/* Two spheres side by side, `first` to `end` of them, the second with an effect more than the first. */
static void render_pair(struct rl_image *image, int first, int end)
{
    struct rl_scene scene;
    fixture_begin(&scene, 80, 40);
    fixture_camera(&scene, v3(0.0, 0.0, 6.0), v3(0.0, 0.0, 0.0), 25.0);
    for (int i = first; i < end; i++)
        fixture_object(&scene, RL_SHAPE_SPHERE, 16, 1.0, v3(i ? 1.1 : -1.1, 0.0, 0.0),
                       fixture_material(&scene, 3.0, 0.0, i ? 0.5 : 0.0, i ? 1.0 : 0.5, "random"));
    fixture_quad(&scene, v3(0.0, 3.0, 3.0), v3(0.5, 0.0, 0.0), v3(0.0, 0.5, -0.5), 1.0, 1.0, 1.0);
    render(image, &scene, -1.0);
    fixture_end(&scene);
}

/* Materials that share the highlight program, and differ in all the rest, look as each does alone. */
static void materials_that_share_a_program_keep_apart(void **state)
{
    (void)state;
    struct rl_image pair;
    struct rl_image alone[2];
    render_pair(&pair, 0, 2);
    render_pair(&alone[0], 0, 1);
    render_pair(&alone[1], 1, 2);
    for (int y = 0; y < 40; y++)
        for (int x = 0; x < 80; x++)
            assert_true(same_pixel(&pair, &alone[x / 40], x, y));
    rl_image_clear(&pair);
    rl_image_clear(&alone[0]);
    rl_image_clear(&alone[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_huge_margin_changes_nothing),
        cmocka_unit_test(a_margin_only_removes),
        cmocka_unit_test(the_pass_is_the_ray_and_sphere_test),
        cmocka_unit_test(spheres_are_by_material),
        cmocka_unit_test(what_was_drawn_is_known),
        cmocka_unit_test(materials_that_share_a_program_keep_apart),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
