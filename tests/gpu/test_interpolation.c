/* What the three interpolations draw, against what follows from their definitions; pictures against the CPU renderer are test_images.c's. */
#include "gpu/fixture.h"

enum { WIDTH = 96, HEIGHT = 72, TRIANGLES = 2 /* of the quad */ };

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

static void draw(struct rl_image *image, const struct rl_scene *scene, int interpolation)
{
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    settings.interpolation = interpolation;
    settings.env_size = 32;
    settings.normal_size = 64;
    fixture_render(image, gpu, scene, &settings);
}

/* A quad of two triangles, seen at a slant so that it is far from linear on the screen; `behind`: it reaches past the eye, and the near plane
 * cuts it. */
static void begin_quad(struct rl_scene *scene, bool behind)
{
    fixture_begin(scene, WIDTH, HEIGHT);
    fixture_camera(scene, v3(0.3, 0.5, behind ? 0.5 : 3.0), v3(0.0, 0.0, -0.5), 40.0);
    fixture_object(scene, RL_SHAPE_PLANE, 1, 2.0, v3(0.0, 0.0, 0.0),
                   fixture_material(scene, 10.0, 0.05, 0.6, 0.0, NULL));
    /* Four values that no plane goes through. */
    fixture_source(scene, false, v3(1.5, 1.0, -1.5), 3.0, 2.0, 1.0);
    fixture_source(scene, false, v3(-1.5, 0.7, 0.5), 0.3, 0.5, 1.0);
}

static rl_vec3 corner(const struct rl_mesh *mesh, size_t triangle, int k)
{
    const float *p = mesh->position[mesh->triangle[triangle][k]];
    return v3(p[0], p[1], p[2]);
}

/* The weights of the corners of the quad's triangle that the pixel sees; false: near an edge, or the background. */
static bool locate(size_t *triangle, double weight[3], const struct rl_scene *scene, int x, int y)
{
    const struct rl_mesh *mesh = &scene->object[0].mesh;
    rl_vec3 d = rl_camera_ray(&scene->camera, scene->width, scene->height, x, y);
    rl_vec3 from = scene->camera.position, P = v3_madd(from, -from.y / d.y, d);
    if (!(d.y < 0.0) || -from.y / d.y * v3_dot(d, scene->camera.forward) < 1.01 * scene->camera.near_plane)
        return false;
    for (*triangle = 0; *triangle < TRIANGLES; ++*triangle) {
        rl_vec3 a = corner(mesh, *triangle, 0), b = corner(mesh, *triangle, 1),
                c = corner(mesh, *triangle, 2);
        double all = v3_cross(v3_sub(b, a), v3_sub(c, a)).y;
        weight[1] = v3_cross(v3_sub(P, a), v3_sub(c, a)).y / all;
        weight[2] = v3_cross(v3_sub(b, a), v3_sub(P, a)).y / all;
        weight[0] = 1.0 - weight[1] - weight[2];
        if (fmin(weight[0], fmin(weight[1], weight[2])) > 0.01)
            return true;
    }
    return false;
}

/* The sum of the effects of material 0 at a point of the scene. */
static void shade(double rgb[3], const struct rl_scene *scene, rl_vec3 P, rl_vec3 N)
{
    struct rl_error error;
    struct rl_lights lights;
    struct rl_plan plan;
    double params[RL_PLAN_EFFECTS_MAX][RL_EFFECT_PARAMS][4];
    const struct rl_surface s = {P, N, v3_normalize(v3_sub(scene->camera.position, P))};
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    check_ok(rl_plan_make(&plan, scene, &settings, &error), &error);
    check_ok(rl_scene_lights_make(&lights, scene, &error), &error);
    const struct rl_plan_material *m = &plan.material[0];
    for (size_t i = 0; i < m->n_effects; i++)
        m->effect[i]->pack(rl_effect_given(&scene->material[0], m->effect[i]), params[i]);
    rl_effects_shade(m->effect, m->n_effects, params, &s, &lights, rgb);
    rl_scene_lights_clear(&lights);
    rl_plan_clear(&plan);
}

/* On each triangle the mean of the corners' values by the weights that the point has in space, not on the screen. */
static void test_gouraud_is_linear(void **state)
{
    (void)state;
    for (int behind = 0; behind < 2; behind++) {
        struct rl_scene scene;
        struct rl_image image;
        begin_quad(&scene, behind);
        draw(&image, &scene, RL_INTERPOLATION_GOURAUD);
        const struct rl_mesh *mesh = &scene.object[0].mesh;
        assert_int_equal(mesh->n_triangles, TRIANGLES);
        double value[TRIANGLES][3][3], worst = 0.0;
        for (size_t t = 0; t < TRIANGLES; t++)
            for (int k = 0; k < 3; k++)
                shade(value[t][k], &scene, corner(mesh, t, k), v3(0.0, 1.0, 0.0));
        size_t pixels = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                size_t t;
                double w[3];
                if (!locate(&t, w, &scene, x, y))
                    continue;
                pixels++;
                for (int c = 0; c < 3; c++) {
                    double mean = w[0] * value[t][0][c] + w[1] * value[t][1][c] + w[2] * value[t][2][c];
                    worst = fmax(worst, fabs(rl_image_pixel(&image, x, y)[c] - mean));
                }
            }
        print_message("%zu pixels within %.1e\n", pixels, worst);
        assert_true(pixels > 1500);
        assert_true(worst < 1e-6);
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

/* One value a triangle, to the bit; it is that of the centroid and of the plane's normal, and no vertex's. */
static void test_constant_is_one_value(void **state)
{
    (void)state;
    for (int behind = 0; behind < 2; behind++) {
        struct rl_scene scene;
        struct rl_image image;
        begin_quad(&scene, behind);
        /* The normals at the vertices have no part in it. */
        struct rl_mesh *mesh = &scene.object[0].mesh;
        for (size_t i = 0; i < mesh->n_vertices; i++)
            memcpy(mesh->normal[i], (float[3]){1.0f, 0.0f, 0.0f}, sizeof mesh->normal[i]);
        draw(&image, &scene, RL_INTERPOLATION_CONSTANT);
        const float *found[TRIANGLES] = {NULL, NULL};
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                size_t t;
                double w[3], expected[3];
                if (!locate(&t, w, &scene, x, y))
                    continue;
                const float *here = rl_image_pixel(&image, x, y);
                if (found[t]) {
                    assert_memory_equal(here, found[t], 4 * sizeof *here);
                    continue;
                }
                found[t] = here;
                rl_vec3 P, N;
                rl_mesh_facet(mesh, t, &P, &N);
                shade(expected, &scene, P, N);
                for (int c = 0; c < 3; c++)
                    check_near(here[c], expected[c], 1e-6);
            }
        assert_true(found[0] && found[1]);
        assert_memory_not_equal(found[0], found[1], 3 * sizeof *found[0]);
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

/* The picture is that of the triangles, in whatever order a mesh lists their corners: any may be the last, from which OpenGL takes the value. */
static void test_order_of_corners(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct rl_image image, turned;
    fixture_begin(&scene, WIDTH, HEIGHT);
    fixture_camera(&scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 32.0);
    fixture_object(&scene, RL_SHAPE_SPHERE, 4, 1.0, v3(0.0, 0.0, 0.0),
                   fixture_material(&scene, 10.0, 0.05, 0.6, 0.0, NULL));
    fixture_source(&scene, false, v3(-2.0, 2.0, 3.0), 5.0, 2.0, 1.0);
    draw(&image, &scene, RL_INTERPOLATION_CONSTANT);
    struct rl_mesh *mesh = &scene.object[0].mesh;
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        uint32_t *k = mesh->triangle[t], first = k[0];
        for (size_t turns = 0; turns < t % 3; turns++, first = k[0]) {
            k[0] = k[1];
            k[1] = k[2];
            k[2] = first;
        }
    }
    draw(&turned, &scene, RL_INTERPOLATION_CONSTANT);
    size_t off = 0;
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        double most = 0.0;
        for (size_t c = 0; c < 4; c++)
            most = fmax(most, fabs((double)image.data[4 * i + c] - (double)turned.data[4 * i + c]));
        off += most > 1e-6;
    }
    assert_int_equal(off, 0);
    rl_image_clear(&image);
    rl_image_clear(&turned);
    fixture_end(&scene);
}

/* Seen from behind, without culling, the quad is shaded as its mirror image is from the front: with normals and triangles turned round. */
static void test_from_behind(void **state)
{
    (void)state;
    for (int i = 0; i < RL_INTERPOLATIONS; i++) {
        struct rl_scene scene;
        struct rl_image behind, front;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        begin_quad(&scene, false);
        fixture_camera(&scene, v3(0.3, -0.5, 3.0), v3(0.0, 0.0, -0.5), 40.0);
        fixture_source(&scene, false, v3(0.5, -1.0, 0.5), 1.0, 2.0, 3.0);
        settings.culling = false;
        settings.interpolation = i;
        fixture_render(&behind, gpu, &scene, &settings);
        struct rl_mesh *mesh = &scene.object[0].mesh;
        for (size_t v = 0; v < mesh->n_vertices; v++)
            mesh->normal[v][1] *= -1.0f;
        for (size_t t = 0; t < mesh->n_triangles; t++) {
            uint32_t *k = mesh->triangle[t], first = k[0];
            k[0] = k[1];
            k[1] = first;
        }
        settings.culling = true;
        fixture_render(&front, gpu, &scene, &settings);
        double brightest = 0.0;
        for (size_t p = 0; p < (size_t)4 * WIDTH * HEIGHT; p++) {
            check_near(behind.data[p], front.data[p], 1e-5);
            brightest = p % 4 < 3 ? fmax(brightest, (double)behind.data[p]) : brightest;
        }
        assert_true(brightest > 0.06); /* more than ambient light */
        rl_image_clear(&behind);
        rl_image_clear(&front);
        fixture_end(&scene);
    }
}

/* A constant effect, and a plane in parallel light, are the same however they are interpolated. */
static void test_modes_agree(void **state)
{
    (void)state;
    for (int lit = 0; lit < 2; lit++) {
        struct rl_scene scene;
        struct rl_image image[RL_INTERPOLATIONS];
        begin_quad(&scene, false);
        scene.n_sources = 0;
        if (lit)
            fixture_source(&scene, true, v3(0.3, 1.0, 0.2), 1.0, 0.7, 0.5);
        for (int i = 0; i < RL_INTERPOLATIONS; i++)
            draw(&image[i], &scene, i);
        size_t foreground = 0;
        for (size_t p = 0; p < (size_t)WIDTH * HEIGHT; p++) {
            foreground += image[0].data[4 * p + 3] > 0.0f && image[0].data[4 * p] > 0.04f;
            for (size_t c = 0; c < 4; c++)
                for (int i = 1; i < RL_INTERPOLATIONS; i++)
                    check_near(image[i].data[4 * p + c], image[0].data[4 * p + c], 1e-6);
        }
        assert_true(foreground > 1500);
        for (int i = 0; i < RL_INTERPOLATIONS; i++)
            rl_image_clear(&image[i]);
        fixture_end(&scene);
    }
}

/* The highlight of a shaped light is each pixel's: what the pass adds, and where it draws, is the same under all three. */
static void test_highlights_stay(void **state)
{
    (void)state;
    static const char *const methods[] = {"plain", "regular", "random"};
    for (size_t m = 0; m < sizeof methods / sizeof methods[0]; m++) {
        struct rl_image added[RL_INTERPOLATIONS];
        for (int i = 0; i < RL_INTERPOLATIONS; i++) {
            struct rl_scene scene;
            struct rl_image bare;
            fixture_sphere(&scene, WIDTH, HEIGHT, methods[m], 10.0);
            draw(&added[i], &scene, i);
            scene.material[0].method = NULL;
            draw(&bare, &scene, i);
            for (size_t p = 0; p < (size_t)4 * WIDTH * HEIGHT; p++)
                added[i].data[p] -= bare.data[p];
            rl_image_clear(&bare);
            fixture_end(&scene);
        }
        double brightest = 0.0;
        size_t off = 0;
        for (size_t p = 0; p < (size_t)4 * WIDTH * HEIGHT; p++) {
            brightest = fmax(brightest, (double)added[0].data[p]);
            for (int i = 1; i < RL_INTERPOLATIONS; i++)
                off += fabs((double)added[i].data[p] - (double)added[0].data[p]) > 1e-5;
        }
        print_message("%s: to %.2f, %zu values off\n", methods[m], brightest, off);
        assert_true(brightest > 0.2);
        assert_int_equal(off, 0);
        for (int i = 0; i < RL_INTERPOLATIONS; i++)
            rl_image_clear(&added[i]);
    }
}

/* What a material says is what the option says of all, to the bit; and phong is what there was before there was a choice. */
static void test_material_or_option(void **state)
{
    (void)state;
    for (int i = 0; i < RL_INTERPOLATIONS; i++) {
        struct rl_scene scene;
        struct rl_image said, asked;
        fixture_sphere(&scene, WIDTH, HEIGHT, NULL, 10.0);
        draw(&asked, &scene, i);
        scene.material[0].interpolation = (enum rl_interpolation)i;
        draw(&said, &scene, RL_INTERPOLATION_OF_MATERIAL);
        assert_memory_equal(said.data, asked.data, (size_t)WIDTH * HEIGHT * 4 * sizeof *said.data);
        rl_image_clear(&said);
        rl_image_clear(&asked);
        fixture_end(&scene);
    }
}

static size_t count_modules(const struct rl_plan *plan)
{
    size_t n = 0;
    for (size_t i = 0; i < plan->n_programs; i++)
        n += plan->program[i].n_modules;
    return n;
}

/* Both stages' modules are compiled, and no others. Vertices are added for triangles with one value each alone, and no more than there are triangles without a last vertex of their own. */
static void test_bytes(void **state)
{
    (void)state;
    for (int i = 0; i < RL_INTERPOLATIONS; i++) {
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_gpu_scene *gs;
        struct rl_error error;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.interpolation = i;
        fixture_sphere(&scene, WIDTH, HEIGHT, NULL, 10.0);
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
        const struct rl_mesh *mesh = &scene.object[0].mesh;
        assert_int_equal(rl_gpu_scene_counters(gs).modules, count_modules(&plan));
        assert_int_equal(rl_gpu_scene_counters(gs).programs, 1);
        size_t light = 48, indices = 12 * mesh->n_triangles;
        size_t vertices = rl_gpu_scene_counters(gs).bytes_uploaded - light - indices;
        if (i == RL_INTERPOLATION_CONSTANT)
            assert_in_range(vertices, 48 * mesh->n_triangles, 48 * mesh->n_triangles * 101 / 100);
        else
            assert_int_equal(vertices, 24 * mesh->n_vertices);
        rl_gpu_scene_free(gs);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gouraud_is_linear),
        cmocka_unit_test(test_constant_is_one_value),
        cmocka_unit_test(test_order_of_corners),
        cmocka_unit_test(test_modes_agree),
        cmocka_unit_test(test_from_behind),
        cmocka_unit_test(test_highlights_stay),
        cmocka_unit_test(test_bytes),
        cmocka_unit_test(test_material_or_option),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
