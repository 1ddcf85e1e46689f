/* The exact visible triangle: against rays by another way, against depths worked out by hand, and what a coarse depth buffer does to it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "reference/raster.h"
#include "reference/visible.h"
#include "scene/shapes.h"
#include "support/check.h"

enum { WIDTH = 64, HEIGHT = 48, OBJECTS = 3 };

static struct rl_error error;

static void look(struct rl_scene *scene, rl_vec3 position, rl_vec3 target, double near, double far)
{
    struct rl_camera *c = &scene->camera;
    c->position = position;
    c->forward = v3_normalize(v3_sub(target, position));
    c->right = v3_normalize(v3_cross(c->forward, v3(0.0, 1.0, 0.0)));
    c->up = v3_cross(c->right, c->forward);
    c->fov_y = 40.0 * RL_PI / 180.0;
    c->near_plane = near;
    c->far_plane = far;
}

/* A shape, scaled, its y axis turned to +z where `upright`, and moved. */
static void add(struct rl_scene *scene, enum rl_shape shape, double scale, bool upright, rl_vec3 at)
{
    struct rl_object *object = &scene->object[scene->n_objects++];
    check_ok(rl_shape_build(&object->mesh, shape, 5, 0.3, &error), &error);
    for (size_t i = 0; i < object->mesh.n_vertices; i++) {
        float *p = object->mesh.position[i], y = p[1];
        p[1] = upright ? -p[2] : y;
        p[2] = upright ? y : p[2];
        p[0] = (float)(scale * p[0] + at.x);
        p[1] = (float)(scale * p[1] + at.y);
        p[2] = (float)(scale * p[2] + at.z);
    }
}

static void clear(struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_objects; i++)
        rl_mesh_clear(&scene->object[i].mesh);
}

/* Objects as Embree finds them, but for pixels whose ray grazes an edge; points on the triangles named. */
static void test_against_rays(void **state)
{
    (void)state;
    for (int culling = 0; culling < 2; culling++) {
        struct rl_object object[OBJECTS] = {{0}};
        struct rl_scene scene = {.object = object};
        struct rl_visible *visible;
        static struct rl_raster_pixel pixel[WIDTH * HEIGHT];
        look(&scene, v3(0.4, 1.2, 3.0), v3(0.0, 0.0, 0.0), 1.9, 3.6);
        add(&scene, RL_SHAPE_TORUS, 1.0, false, v3(0.0, 0.0, 0.0));
        add(&scene, RL_SHAPE_SPHERE, 0.6, false, v3(0.1, 0.0, 0.0));
        add(&scene, RL_SHAPE_PLANE, 3.0, true, v3(0.0, 0.0, -0.2)); /* reaches behind the eye's planes */
        const struct rl_raster_options options = {.width = WIDTH, .height = HEIGHT, .culling = culling};
        check_ok(rl_visible_make(&visible, &scene, NULL, culling, &error), &error);
        rl_raster_draw(pixel, &scene, &options);
        size_t differ = 0, seen[OBJECTS + 1] = {0};
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const struct rl_raster_pixel *p = &pixel[y * WIDTH + x];
                struct rl_surface surface;
                struct rl_visible_hit hit = {0};
                rl_vec3 ray = rl_camera_ray(&scene.camera, WIDTH, HEIGHT, x, y);
                bool there = rl_visible_point(&surface, &hit, visible, ray);
                seen[p->object]++;
                differ += p->object != (there ? hit.object + 1 : 0);
                if (p->object == 0 || p->object != hit.object + 1)
                    continue;
                double z = v3_dot(v3_sub(surface.P, scene.camera.position), scene.camera.forward);
                check_near(p->z, z, 1e-6);
                check_near(rl_raster_depth(&scene, &options, p->object, p->triangle, x, y), p->z, 1e-12);
                assert_true(p->gap > 0.0);
            }
        assert_true(differ <= 4);
        for (int i = 0; i <= OBJECTS; i++)
            assert_true(seen[i] > 50);
        rl_visible_free(visible);
        clear(&scene);
    }
}

/* Two walls at 4 and 4 + gap, the farther one first; z and gap are known. */
static void make_walls(struct rl_scene *scene, double gap)
{
    look(scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 0.1, 10.0);
    add(scene, RL_SHAPE_PLANE, 8.0, true, v3(0.0, 0.0, -gap));
    add(scene, RL_SHAPE_PLANE, 8.0, true, v3(0.0, 0.0, 0.0));
}

static void test_walls(void **state)
{
    (void)state;
    struct rl_object object[OBJECTS] = {{0}};
    struct rl_scene scene = {.object = object};
    static struct rl_raster_pixel pixel[WIDTH * HEIGHT];
    const double gap = 0x1p-10;
    int edge = 0;
    make_walls(&scene, gap);
    struct rl_raster_options options = {.width = WIDTH, .height = HEIGHT, .culling = true};
    rl_raster_draw(pixel, &scene, &options);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        assert_int_equal(pixel[i].object, 2);
        check_near(pixel[i].z, 4.0, 1e-12);
        /* Both triangles of the near wall meet the rays through its diagonal. */
        edge += pixel[i].gap < 1e-12;
        if (!(pixel[i].gap < 1e-12))
            check_near(pixel[i].gap, gap, 1e-12);
    }
    assert_true(edge <= HEIGHT);
    /* From behind, with a camera that looks the other way, nothing. */
    look(&scene, v3(0.0, 0.0, -4.0), v3(0.0, 0.0, 0.0), 0.1, 10.0);
    rl_raster_draw(pixel, &scene, &options);
    assert_int_equal(pixel[0].object, 0);
    options.culling = false;
    rl_raster_draw(pixel, &scene, &options);
    assert_int_equal(pixel[0].object, 1);
    clear(&scene);
}

/* The CPU renderer tells walls apart that single precision does not, at a distance of 4 and seen aslant. */
static void test_close_walls(void **state)
{
    (void)state;
    static const double gaps[] = {1e-5, 1e-6, 1e-7, 1e-9};
    for (size_t k = 0; k < 2 * sizeof gaps / sizeof gaps[0]; k++) {
        struct rl_object object[OBJECTS] = {{0}};
        struct rl_scene scene = {.object = object};
        struct rl_visible *visible;
        size_t near = k % 2; /* the near wall is the first of the scene, or the second */
        make_walls(&scene, near ? gaps[k / 2] : -gaps[k / 2]);
        look(&scene, v3(1.0, 2.0, 3.4), v3(0.0, 0.0, 0.0), 0.1, 30.0);
        check_ok(rl_visible_make(&visible, &scene, NULL, true, &error), &error);
        size_t wrong = 0;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            struct rl_surface surface;
            struct rl_visible_hit hit = {0};
            rl_vec3 ray = rl_camera_ray(&scene.camera, WIDTH, HEIGHT, i % WIDTH, i / WIDTH);
            assert_true(rl_visible_point(&surface, &hit, visible, ray));
            wrong += hit.object != near;
        }
        assert_int_equal(wrong, 0);
        rl_visible_free(visible);
        clear(&scene);
    }
}

/* A step is z^2 (f - n)/(f n 2^b): less than half of it apart the walls are one, and the first drawn stays; more than one apart
 * they never are. */
static void test_coarse_depth(void **state)
{
    (void)state;
    static const struct {
        int bits;
        bool reversed;
    } kind[] = {{16, false}, {24, false}, {16, true}, {32, true}, {32, false}};
    for (size_t k = 0; k < sizeof kind / sizeof kind[0]; k++) {
        struct rl_raster_options options = {.width = WIDTH,
                                            .height = HEIGHT,
                                            .culling = true,
                                            .depth_bits = kind[k].bits,
                                            .reversed_depth = kind[k].reversed};
        struct rl_object object[OBJECTS] = {{0}};
        struct rl_scene scene = {.object = object};
        look(&scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 0.1, 10.0);
        double step = rl_raster_resolution(&scene.camera, &options, 4.0);
        if (kind[k].bits < 32)
            check_near(step / (16.0 * 9.9 / (10.0 * 0.1) / ldexp(1.0, kind[k].bits)), 1.0, 2e-5);
        for (int wide = 0; wide < 2; wide++) {
            static struct rl_raster_pixel pixel[WIDTH * HEIGHT];
            /* Positions are floats: gaps that they hold. */
            double gap = (double)(float)(4.0 + (wide ? 2.0 : 0.4) * step) - 4.0;
            scene.n_objects = 0;
            make_walls(&scene, gap > 0.0 ? gap : 0x1p-21);
            rl_raster_draw(pixel, &scene, &options);
            size_t right = 0;
            for (int i = 0; i < WIDTH * HEIGHT; i++)
                right += pixel[i].object == 2;
            if (wide)
                assert_int_equal(right, (size_t)WIDTH * HEIGHT);
            clear(&scene);
            /* Where in a step the walls lie decides of close ones; at a depth of exactly whole steps they would be one. */
            if (!wide && kind[k].bits == 16)
                assert_true(right == 0 || right == (size_t)WIDTH * HEIGHT);
        }
    }
    /* Float near 1 is as fine as 24 bits, reversed it is finer by far. */
    struct rl_scene scene = {0};
    look(&scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 1e-4, 10.0);
    struct rl_raster_options whole = {.depth_bits = 24}, plain = {.depth_bits = 32},
                             reversed = {.depth_bits = 32, .reversed_depth = true};
    check_near(rl_raster_resolution(&scene.camera, &plain, 4.0) /
                   rl_raster_resolution(&scene.camera, &whole, 4.0),
               1.0, 1e-6);
    assert_true(rl_raster_resolution(&scene.camera, &reversed, 4.0) <
                1e-4 * rl_raster_resolution(&scene.camera, &plain, 4.0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_rays),
        cmocka_unit_test(test_walls),
        cmocka_unit_test(test_close_walls),
        cmocka_unit_test(test_coarse_depth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
