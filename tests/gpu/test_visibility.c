/* Which surface a pixel shows: the depth buffer's bits and direction, back faces culled or not, the camera's planes. */
#include "gpu/fixture.h"
#include "reference/renderer.h"

enum { WIDTH = 96, HEIGHT = 72 };

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

/* A ball and a ring, closed, that hide parts of themselves and of each other. */
static void begin_closed(struct rl_scene *scene, const char *method)
{
    fixture_begin(scene, WIDTH, HEIGHT);
    fixture_camera(scene, v3(0.5, 1.5, 4.0), v3(0.0, 0.0, 0.0), 40.0);
    int material = fixture_material(scene, 30.0, 0.1, 0.4, 1.0, method);
    fixture_object(scene, RL_SHAPE_TORUS, 12, 1.2, v3(0.0, 0.0, 0.0), material);
    fixture_object(scene, RL_SHAPE_SPHERE, 12, 0.7, v3(0.1, 0.2, 0.0), material);
    fixture_quad(scene, v3(-2.0, 2.0, 3.0), v3(0.8, 0.8, 0.0), v3(0.5, -0.5, 0.5), 2.0, 1.5, 1.0);
}

/* A plane seen from behind, lit from both sides, one light brighter. */
static void begin_behind(struct rl_scene *scene, const char *method)
{
    fixture_begin(scene, WIDTH, HEIGHT);
    fixture_camera(scene, v3(0.3, -3.0, 0.8), v3(0.0, 0.0, 0.0), 40.0);
    fixture_object(scene, RL_SHAPE_PLANE, 3, 1.0, v3(0.0, 0.0, 0.0),
                   fixture_material(scene, 30.0, 0.1, 0.4, 1.0, method));
    fixture_quad(scene, v3(0.0, -2.0, -1.0), v3(0.8, 0.0, 0.0), v3(0.0, 0.0, 0.8), 1.0, 0.5, 0.25);
    fixture_quad(scene, v3(0.0, 2.0, -1.0), v3(0.8, 0.0, 0.0), v3(0.0, 0.0, 0.8), 8.0, 4.0, 2.0);
}

static void check_same(const struct rl_image *a, const struct rl_image *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_int_equal(a->channels, b->channels);
    assert_memory_equal(a->data, b->data,
                        (size_t)a->width * (size_t)a->height * (size_t)a->channels * sizeof *a->data);
}

static size_t n_drawn(const struct rl_image *image)
{
    size_t n = 0;
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
        n += image->data[4 * i + 3] > 0.0f;
    return n;
}

/* The bits asked for are those that OpenGL gave, and a stencil is there only for the passes that use one. */
static void depth_is_what_was_asked_for(void **state)
{
    (void)state;
    static const struct {
        const char *method;
        int bits, stencil;
    } row[] = {{NULL, 16, 0},    {NULL, 24, 0},    {NULL, 32, 0},     {"plain", 16, 0},
               {"plain", 24, 0}, {"plain", 32, 0}, {"random", 24, 8}, {"regular", 32, 8}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_gpu_scene *gs;
        int depth = -1, stencil = -1;
        double seconds;
        begin_closed(&scene, row[i].method);
        scene.settings.depth_bits = row[i].bits;
        check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
        assert_int_equal(plan.stencil, row[i].stencil > 0);
        check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
        check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
        rl_gpu_scene_depth(gs, &depth, &stencil);
        assert_int_equal(depth, row[i].bits);
        assert_int_equal(stencil, row[i].stencil);
        rl_gpu_scene_free(gs);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
}

static void a_stencil_beside_16_bits_is_refused(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    static char path[] = "x.yaml";
    begin_closed(&scene, "random");
    scene.path = path;
    scene.settings.depth_bits = 16;
    check_fails(rl_plan_make(&plan, &scene, &scene.settings, &error), &error, RL_ERR_INPUT,
                "x.yaml: a depth buffer of 16 bits, which has no stencil beside it, and the method random");
    assert_non_null(strstr(error.message, "--depth-bits 24 or 32"));
    assert_non_null(strstr(error.message, "--method plain"));
    /* The highlight that no light gives asks for nothing; nor does the CPU. */
    scene.n_lights = 0;
    check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
    assert_false(plan.stencil);
    rl_plan_clear(&plan);
    scene.n_lights = 1;
    scene.settings.method = "reference";
    check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

/* Between planes that fit the scene every depth buffer tells these surfaces apart. */
static void no_depth_buffer_changes_a_roomy_scene(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_image expected, image;
    begin_closed(&scene, "plain");
    scene.camera.near_plane = 2.0;
    scene.camera.far_plane = 8.0;
    fixture_render(&expected, gpu, &scene, &scene.settings);
    assert_true(n_drawn(&expected) > WIDTH * HEIGHT / 4);
    for (int bits = 16; bits <= 32; bits += 8)
        for (int reversed = 0; reversed < 2; reversed++) {
            scene.settings.depth_bits = bits;
            scene.settings.reversed_depth = reversed;
            fixture_render(&image, gpu, &scene, &scene.settings);
            check_same(&image, &expected);
            rl_image_clear(&image);
        }
    rl_image_clear(&expected);
    fixture_end(&scene);
}

/* Of two planes at a distance of 10 the farther one, drawn first, shows through where the depth buffer takes them for one: z^2/(near 2^b)
 * is 1.5 with 16 bits and near = 0.001, and 0.006 with 24, and float is no finer near 1; reversed it resolves 1e-6. */
static void close_surfaces_need_bits(void **state)
{
    (void)state;
    static const struct {
        int bits;
        bool reversed, right;
        double gap;
    } row[] = {{16, false, false, 0.1},  {16, false, true, 4.0},   {24, false, true, 0.1},
               {24, false, false, 1e-4}, {32, false, false, 1e-4}, {32, true, true, 1e-4}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_scene scene;
        struct rl_image image;
        fixture_begin(&scene, WIDTH, HEIGHT);
        fixture_camera(&scene, v3(0.0, 10.0, 1e-4), v3(0.0, 0.0, 0.0), 8.0);
        scene.camera.near_plane = 1e-3;
        scene.camera.far_plane = 20.0;
        int far = fixture_material(&scene, 1.0, 1.0, 0.0, 0.0, NULL);
        int near = fixture_material(&scene, 1.0, 0.5, 0.0, 0.0, NULL);
        fixture_object(&scene, RL_SHAPE_PLANE, 1, 4.0, v3(0.0, 0.0, 0.0), far);
        fixture_object(&scene, RL_SHAPE_PLANE, 1, 4.0, v3(0.0, row[i].gap, 0.0), near);
        scene.settings.depth_bits = row[i].bits;
        scene.settings.reversed_depth = row[i].reversed;
        fixture_render(&image, gpu, &scene, &scene.settings);
        size_t right = 0;
        for (size_t k = 0; k < (size_t)WIDTH * HEIGHT; k++)
            right += image.data[4 * k] == 0.5f;
        if (row[i].right)
            assert_int_equal(right, (size_t)WIDTH * HEIGHT);
        else
            assert_true(right < (size_t)WIDTH * HEIGHT);
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

static void culling_changes_no_bit_of_closed_meshes(void **state)
{
    (void)state;
    static const char *const methods[] = {NULL, "plain", "regular", "random"};
    for (size_t m = 0; m < sizeof methods / sizeof methods[0]; m++) {
        struct rl_scene scene;
        struct rl_image with, without;
        begin_closed(&scene, methods[m]);
        fixture_render(&with, gpu, &scene, &scene.settings);
        assert_true(n_drawn(&with) > WIDTH * HEIGHT / 4);
        scene.settings.culling = false;
        fixture_render(&without, gpu, &scene, &scene.settings);
        check_same(&with, &without);
        rl_image_clear(&with);
        rl_image_clear(&without);
        fixture_end(&scene);
    }
}

/* What is culled is counted: of a ball half, from afar. */
static void culled_triangles_are_counted(void **state)
{
    (void)state;
    struct rl_error error;
    for (int culling = 0; culling < 2; culling++) {
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_gpu_scene *gs;
        double seconds;
        fixture_begin(&scene, WIDTH, HEIGHT);
        fixture_camera(&scene, v3(5.0, 3.0, 90.0), v3(0.0, 0.0, 0.0), 2.0);
        fixture_object(&scene, RL_SHAPE_SPHERE, 16, 1.0, v3(0.0, 0.0, 0.0),
                       fixture_material(&scene, 1.0, 0.5, 0.0, 0.0, NULL));
        scene.settings.culling = culling;
        check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
        check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
        rl_gpu_scene_reset_counters(gs);
        check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
        const struct rl_gpu_counters c = rl_gpu_scene_counters(gs);
        assert_int_equal(c.triangles, scene.object[0].mesh.n_triangles);
        if (culling)
            check_near((double)c.triangles_culled / (double)c.triangles, 0.5, 0.05);
        else
            assert_int_equal(c.triangles_culled, 0);
        rl_gpu_scene_free(gs);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
}

/* The back of a plane: culled, or lit as the side that the eye sees, by both renderers. */
static void backs_are_shaded_alike(void **state)
{
    (void)state;
    static const char *const methods[] = {NULL, "plain"};
    for (size_t m = 0; m < sizeof methods / sizeof methods[0]; m++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_image gpu_image, cpu_image;
        struct rl_plan plan;
        struct rl_render_stats stats;
        begin_behind(&scene, methods[m]);
        fixture_render(&gpu_image, gpu, &scene, &scene.settings);
        assert_int_equal(n_drawn(&gpu_image), 0);
        rl_image_clear(&gpu_image);
        scene.settings.culling = false;
        fixture_render(&gpu_image, gpu, &scene, &scene.settings);
        assert_true(n_drawn(&gpu_image) > WIDTH * HEIGHT / 4);
        check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
        assert_int_equal(plan.n_lights, 2); /* none is behind what is seen from both sides */
        check_ok(rl_reference_render(&cpu_image, &stats, &scene, &plan, 1, NULL, &error), &error);
        size_t lit = 0, outline = 0;
        for (size_t i = 0; i < (size_t)WIDTH * HEIGHT * 4; i += 4) {
            outline += (gpu_image.data[i + 3] > 0.0f) != (cpu_image.data[i + 3] > 0.0f);
            if (gpu_image.data[i + 3] > 0.0f && cpu_image.data[i + 3] > 0.0f)
                for (size_t c = 0; c < 3; c++)
                    check_near(gpu_image.data[i + c], cpu_image.data[i + c], 1e-4);
            /* More than ambient light, and not the other side's light, which is eight times as bright. */
            lit += gpu_image.data[i] > 0.105f && gpu_image.data[i] < 1.5f;
        }
        assert_true(outline < 8);
        assert_true(lit > WIDTH * HEIGHT / 4);
        rl_image_clear(&gpu_image);
        rl_image_clear(&cpu_image);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
}

/* What is nearer than the near plane or beyond the far one is cut off, on both sides alike. */
static void planes_cut(void **state)
{
    (void)state;
    static const double planes[][2] = {{0.1, 100.0}, {3.7, 100.0}, {0.1, 3.9}, {3.7, 3.9}};
    size_t before = 0;
    for (size_t i = 0; i < sizeof planes / sizeof planes[0]; i++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_image gpu_image, cpu_image;
        struct rl_plan plan;
        struct rl_render_stats stats;
        begin_closed(&scene, NULL);
        scene.settings.culling = false;
        scene.camera.near_plane = planes[i][0];
        scene.camera.far_plane = planes[i][1];
        fixture_render(&gpu_image, gpu, &scene, &scene.settings);
        check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
        check_ok(rl_reference_render(&cpu_image, &stats, &scene, &plan, 1, NULL, &error), &error);
        size_t n = n_drawn(&gpu_image), differ = 0;
        for (size_t k = 0; k < (size_t)WIDTH * HEIGHT * 4; k += 4)
            differ += (gpu_image.data[k + 3] > 0.0f) != (cpu_image.data[k + 3] > 0.0f);
        assert_true(i == 0 || n < before);
        assert_true(differ <= n / 50);
        before = i == 0 ? n : before;
        rl_image_clear(&gpu_image);
        rl_image_clear(&cpu_image);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
    /* An object that none of it is left of is not in the plan. */
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    begin_closed(&scene, NULL);
    scene.camera.far_plane = 2.0;
    check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
    assert_false(plan.object[0].drawn);
    assert_false(plan.object[1].drawn);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

/* Numbers of objects and triangles where something is drawn, 0 where not; the triangle is one that covers the pixel. */
static void identities_are_those_of_the_picture(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    struct rl_image image, identity;
    double seconds;
    begin_closed(&scene, NULL);
    /* So the picture tells the objects apart. */
    scene.object[1].material = fixture_material(&scene, 1.0, 0.9, 0.0, 0.0, NULL);
    rl_effect_give_colour(&scene.material[0], "ambient", 0.1, 0.1, 0.1);
    check_ok(rl_plan_make(&plan, &scene, &scene.settings, &error), &error);
    check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
    rl_gpu_scene_reset_counters(gs);
    check_ok(rl_gpu_scene_read_identity(gs, &identity, &error), &error);
    assert_int_equal(rl_gpu_scene_counters(gs).draws, 0); /* no part of a frame */
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(gs, &image, &error), &error);
    size_t of[3] = {0};
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *id = rl_image_pixel(&identity, x, y), *colour = rl_image_pixel(&image, x, y);
            int object = (int)id[0], triangle = (int)id[1];
            assert_in_range(object, 0, 2);
            of[object]++;
            assert_int_equal(object > 0, colour[3] > 0.0f);
            assert_int_equal(object == 2, colour[0] == 0.9f);
            if (object == 0)
                continue;
            const struct rl_mesh *mesh = &scene.object[object - 1].mesh;
            assert_in_range(triangle, 1, mesh->n_triangles);
            /* The pixel's ray passes inside of the triangle's edges, or nearly so. */
            rl_vec3 ray = rl_camera_ray(&scene.camera, WIDTH, HEIGHT, x, y), corner[3];
            for (int k = 0; k < 3; k++) {
                const float *p = mesh->position[mesh->triangle[triangle - 1][k]];
                corner[k] = v3_normalize(v3_sub(v3(p[0], p[1], p[2]), scene.camera.position));
            }
            for (int k = 0; k < 3; k++)
                assert_true(v3_dot(ray, v3_cross(corner[k], corner[(k + 1) % 3])) < 1e-5);
        }
    assert_true(of[0] > 100 && of[1] > 100 && of[2] > 100);
    rl_image_clear(&image);
    rl_image_clear(&identity);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_is_what_was_asked_for),
        cmocka_unit_test(a_stencil_beside_16_bits_is_refused),
        cmocka_unit_test(no_depth_buffer_changes_a_roomy_scene),
        cmocka_unit_test(close_surfaces_need_bits),
        cmocka_unit_test(culling_changes_no_bit_of_closed_meshes),
        cmocka_unit_test(culled_triangles_are_counted),
        cmocka_unit_test(backs_are_shaded_alike),
        cmocka_unit_test(planes_cut),
        cmocka_unit_test(identities_are_those_of_the_picture),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
