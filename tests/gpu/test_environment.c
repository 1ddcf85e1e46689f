/* Environment maps: every texel shows what a ray from the object's centre through it meets. */
#include <stdbool.h>

#include "gpu/fixture.h"
#include "reference/cube_map.h"
#include "reference/texel_edges.h"

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

/* A small sphere about `centre` whose map is asked for. */
static void begin(struct rl_scene *scene, rl_vec3 centre)
{
    fixture_begin(scene, 16, 12);
    fixture_camera(scene, v3_add(centre, v3(0.0, 0.0, 3.0)), centre, 40.0);
    fixture_object(scene, RL_SHAPE_SPHERE, 4, 0.1, centre,
                   fixture_material(scene, 10.0, 0.0, 0.1, 1.0, "random"));
}

static void read_environment(struct rl_image *image, const struct rl_scene *scene,
                             const struct rl_settings *settings)
{
    struct rl_error error;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    check_ok(rl_plan_make(&plan, scene, settings, &error), &error);
    check_ok(rl_gpu_scene_make(&gs, gpu, scene, &plan, &error), &error);
    check_ok(rl_gpu_scene_read_environment(gs, 0, image, &error), &error);
    check_fails(rl_gpu_scene_read_environment(gs, 1, image, &error), &error, RL_ERR_INPUT, "object 1");
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
}

/* The direction of a texel's centre, not normalised: OpenGL 4.5 core, table 8.19 solved for the direction. */
static rl_vec3 texel_direction(int face, double s, double t)
{
    switch (face) {
    case 0:
        return v3(1.0, -t, -s);
    case 1:
        return v3(-1.0, -t, s);
    case 2:
        return v3(s, 1.0, t);
    case 3:
        return v3(s, -1.0, -t);
    case 4:
        return v3(s, -t, 1.0);
    default:
        return v3(-s, -t, -1.0);
    }
}

/* Distance along `direction` to a triangle, or 0 (Moeller and Trumbore 1997). */
static double meet_triangle(rl_vec3 from, rl_vec3 direction, const rl_vec3 v[3])
{
    rl_vec3 e1 = v3_sub(v[1], v[0]);
    rl_vec3 e2 = v3_sub(v[2], v[0]);
    rl_vec3 p = v3_cross(direction, e2);
    double det = v3_dot(e1, p);
    if (det == 0.0)
        return 0.0;
    rl_vec3 d = v3_sub(from, v[0]);
    rl_vec3 q = v3_cross(d, e1);
    double a = v3_dot(d, p) / det;
    double b = v3_dot(direction, q) / det;
    double t = v3_dot(e2, q) / det;
    return a >= 0.0 && b >= 0.0 && a + b <= 1.0 && t > 0.0 ? t : 0.0;
}

/* The light that the ray meets first, or -1. */
static int first_light(const struct rl_scene *scene, rl_vec3 from, rl_vec3 direction)
{
    int found = -1;
    double nearest = INFINITY;
    for (size_t i = 0; i < scene->n_lights; i++) {
        const struct rl_polygon *p = &scene->light[i].polygon[0];
        for (int k = 0; k < p->n - 2; k++) {
            const rl_vec3 v[3] = {p->vertex[p->triangle[k][0]], p->vertex[p->triangle[k][1]],
                                  p->vertex[p->triangle[k][2]]};
            double t = meet_triangle(from, direction, v);
            if (t > 0.0 && t < nearest) {
                nearest = t;
                found = (int)i;
            }
        }
    }
    return found;
}

/* Texels whose radiance is not that of the first light along the ray; *lit counts texels with a light. */
static size_t count_wrong(const struct rl_image *image, const struct rl_scene *scene, double tolerance,
                          size_t *lit)
{
    int size = image->height;
    size_t wrong = 0;
    *lit = 0;
    for (int face = 0; face < 6; face++)
        for (int y = 0; y < size; y++)
            for (int x = 0; x < size; x++) {
                rl_vec3 d = texel_direction(face, 2.0 * (x + 0.5) / size - 1.0, 2.0 * (y + 0.5) / size - 1.0);
                const float *found = rl_image_pixel(image, face * size + x, y);
                int light = first_light(scene, scene->object[0].centre, d);
                bool right = true;
                for (int c = 0; c < 3; c++)
                    right = right &&
                            fabs(found[c] - (light < 0 ? 0.0 : scene->light[light].radiance[c])) <= tolerance;
                wrong += !right;
                *lit += light >= 0;
            }
    return wrong;
}

/* Solid angle of a triangle seen from the origin (Van Oosterom and Strackee 1983). */
static double triangle_solid_angle(rl_vec3 a, rl_vec3 b, rl_vec3 c)
{
    a = v3_normalize(a);
    b = v3_normalize(b);
    c = v3_normalize(c);
    return 2.0 * fabs(atan2(v3_dot(a, v3_cross(b, c)), 1.0 + v3_dot(a, b) + v3_dot(b, c) + v3_dot(c, a)));
}

static double map_solid_angle(const struct rl_image *image)
{
    int size = image->height;
    double sum = 0.0;
    for (int face = 0; face < 6; face++)
        for (int y = 0; y < size; y++)
            for (int x = 0; x < size; x++) {
                double s = 2.0 * (x + 0.5) / size - 1.0;
                double t = 2.0 * (y + 0.5) / size - 1.0;
                if (rl_image_pixel(image, face * size + x, y)[0] > 0.0f)
                    sum += 4.0 / ((double)size * size) * pow(1.0 + s * s + t * t, -1.5);
            }
    return sum;
}

/* A quad in any direction, over edges and corners of the cube, has its solid angle, and each texel is right
 * but for those that an edge goes through. */
static void a_quad_has_its_solid_angle(void **state)
{
    (void)state;
    static const rl_vec3 towards[] = {
        {1, 0, 0},         {-1, 0, 0},        {0, 1, 0},         {0, -1, 0},   {0, 0, 1},
        {0, 0, -1},        {1, 1, 0},         {0, -1, -1},       {1, 0.9, -1}, {-1, -1, 1},
        {0.3, -0.9, 0.45}, {-0.8, 0.1, -0.6}, {0.2, 0.95, -0.1},
    };
    const rl_vec3 centre = v3(0.3, -0.2, 0.5);
    for (size_t i = 0; i < sizeof towards / sizeof towards[0]; i++) {
        struct rl_scene scene;
        struct rl_image image;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        begin(&scene, centre);
        rl_vec3 n = v3_normalize(towards[i]);
        rl_vec3 u = v3_normalize(v3_cross(n, fabs(n.x) < 0.6 ? v3(1.0, 0.2, 0.0) : v3(0.0, 1.0, 0.3)));
        rl_vec3 v = v3_cross(n, u);
        fixture_quad(&scene, v3_madd(centre, 2.0, n), v3_scale(0.9, u), v3_madd(v3_scale(0.6, v), 0.4, n),
                     1.0, 1.0, 1.0);
        read_environment(&image, &scene, &settings);
        const rl_vec3 *p = scene.light[0].polygon[0].vertex;
        rl_vec3 q[4];
        for (int k = 0; k < 4; k++)
            q[k] = v3_sub(p[k], centre);
        double exact = triangle_solid_angle(q[0], q[1], q[2]) + triangle_solid_angle(q[0], q[2], q[3]);
        check_relative(map_solid_angle(&image), exact, 2e-3);
        size_t lit;
        size_t wrong = count_wrong(&image, &scene, 1e-6, &lit);
        assert_true(lit > 5000);
        if (wrong > 3)
            fail_msg("direction %zu: %zu of %zu lit texels are wrong", i, wrong, lit);
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

/* The CPU's map of the method `exhaustive` holds what the GPU's does, texel for texel, but where an edge passes through the texel: the
 * GPU's vertices are floats, and its raster is finer than a texel but not as fine as a double. */
static void the_cpu_draws_the_same_map(void **state)
{
    (void)state;
    const rl_vec3 centre = v3(0.3, -0.2, 0.5);
    static const rl_vec3 star[8] = {{-2, -2, 1}, {-0.3, -0.3, 1.2}, {-2, 2, 1.8}, {-0.3, 0.3, 1.5},
                                    {2, 2, 2},   {0.3, 0.3, 1.5},   {2, -2, 1.2}, {0.3, -0.3, 1.2}};
    struct rl_error error;
    struct rl_scene scene;
    struct rl_image image;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    settings.env_format = RL_TEXEL_RGBA32F;
    begin(&scene, centre);
    rl_vec3 tilted[8];
    for (int i = 0; i < 8; i++)
        tilted[i] = v3(star[i].x, star[i].y, 1.0 + 0.2 * star[i].x - 0.1 * star[i].y);
    fixture_light(&scene, tilted, 8, 1.0, 0.5, 0.25);
    fixture_quad(&scene, v3(0.5, 0.4, 0.9), v3(0.7, 0.1, 0.0), v3(0.0, 0.6, 0.3), 0.5, 1.0, 0.75);
    fixture_quad(&scene, v3(1.5, -1.0, 0.0), v3(0.0, 1.0, 0.3), v3(0.4, 0.0, 2.0), 0.1, 0.2, 0.3);
    fixture_quad(&scene, v3(-1.0, -2.0, -1.0), v3(3.0, 0.1, 0.0), v3(0.3, 0.2, 2.0), 0.9, 0.8, 0.7);
    read_environment(&image, &scene, &settings);

    int size = settings.env_size;
    struct rl_light_set *set;
    struct rl_cube_map map;
    struct rl_texel_edges edges;
    check_ok(rl_light_set_make(&set, scene.light, scene.n_lights, &error), &error);
    check_ok(rl_cube_map_make(&map, set, scene.object[0].centre, size, &error), &error);
    check_ok(rl_texel_edges_find(&edges, set, scene.object[0].centre, size, &error), &error);
    bool *on_edge = calloc(6 * (size_t)size * (size_t)size, sizeof *on_edge);
    for (size_t i = 0; i < edges.n; i++)
        on_edge[edges.edge[i].texel] = true;
    size_t lit = 0, differ = 0, differ_inside = 0;
    for (int i = 0; i < 6 * size * size; i++) {
        const float *texel = rl_image_pixel(&image, i / (size * size) * size + i % size, i / size % size);
        bool same = true;
        for (int c = 0; c < 3; c++)
            same = same && texel[c] == (float)(map.seen[i] ? set->radiance[map.seen[i] - 1][c] : 0.0);
        lit += map.seen[i] > 0;
        differ += !same;
        differ_inside += !same && !on_edge[i];
    }
    print_message("%zu lit texels, %zu differ, %zu of them without an edge\n", lit, differ, differ_inside);
    assert_true(lit > 50000);
    assert_in_range(differ, 0, lit / 2000);
    assert_in_range(differ_inside, 0, 3); /* where polygons pierce one another */
    free(on_edge);
    rl_texel_edges_clear(&edges);
    rl_cube_map_clear(&map);
    rl_light_set_free(set);
    rl_image_clear(&image);
    fixture_end(&scene);
}

/* Whatever order they are drawn in, and however unlike their distances. */
static void the_nearest_light_wins(void **state)
{
    (void)state;
    static const double distances[][2] = {
        {1.0, 2.0}, {1.0, 1.001}, {0.01, 1.0}, {1.0, 1000.0}, {100.0, 100.5}};
    for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++)
        for (int swapped = 0; swapped < 2; swapped++) {
            struct rl_scene scene;
            struct rl_image image;
            struct rl_settings settings = RL_SETTINGS_DEFAULT;
            settings.env_size = 64;
            begin(&scene, v3(0.0, 0.0, 0.0));
            for (int k = 0; k < 2; k++) {
                int which = swapped ? 1 - k : k;
                double d = distances[i][which];
                double half = which == 0 ? 0.3 * d : 0.7 * d;
                double radiance = which == 0 ? 0.5 : 1.0;
                fixture_quad(&scene, v3(0.1 * d, 0.05 * d, -d), v3(half, 0.0, 0.0), v3(0.0, half, 0.1 * half),
                             radiance, 1.0, 1.0 - radiance);
            }
            read_environment(&image, &scene, &settings);
            size_t lit;
            size_t wrong = count_wrong(&image, &scene, 1.0 / 255, &lit);
            if (wrong > 2)
                fail_msg("distances %g and %g: %zu of %zu lit texels are wrong", distances[i][0],
                         distances[i][1], wrong, lit);
            rl_image_clear(&image);
            fixture_end(&scene);
        }
}

/* Three lights of very different radiance come back within what the format can hold; far outside [0, 1] too.
 * */
static void every_format_keeps_radiance(void **state)
{
    (void)state;
    static const struct {
        enum rl_texel_format format;
        double absolute; /* of the brightest radiance */
        double relative;
    } rows[] = {
        {RL_TEXEL_RGBA8, 0.5 / 255, 0.0},      {RL_TEXEL_RGB10A2, 0.5 / 1023, 0.0},
        {RL_TEXEL_R11G11B10F, 1e-6, 1.0 / 32}, {RL_TEXEL_RGBA16, 0.5 / 65535, 0.0},
        {RL_TEXEL_RGBA16F, 1e-7, 1.0 / 2048},  {RL_TEXEL_RGBA32F, 0.0, 1e-6},
    };
    static const double scales[] = {1.0, 0.3, 1e-4, 3e5, 1e30};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        for (size_t j = 0; j < sizeof scales / sizeof scales[0]; j++) {
            double k = scales[j];
            struct rl_scene scene;
            struct rl_image image;
            struct rl_settings settings = RL_SETTINGS_DEFAULT;
            settings.env_format = rows[i].format;
            settings.env_size = 32;
            begin(&scene, v3(0.0, 0.0, 0.0));
            fixture_quad(&scene, v3(2.0, 0.0, 0.0), v3(0.0, 1.0, 0.0), v3(0.0, 0.0, 1.0), k, 0.7 * k,
                         0.11 * k);
            fixture_quad(&scene, v3(0.0, -2.0, 0.0), v3(1.0, 0.0, 0.0), v3(0.0, 0.0, 1.0), 0.01 * k, 0.5 * k,
                         0.003 * k);
            read_environment(&image, &scene, &settings);
            const int faces[2] = {0, 3};
            for (int light = 0; light < 2; light++)
                for (int c = 0; c < 3; c++) {
                    double expected = scene.light[light].radiance[c];
                    double found = rl_image_pixel(&image, faces[light] * 32 + 16, 16)[c];
                    check_near(found, expected,
                               1.001 * (rows[i].absolute * k + rows[i].relative * expected) + 1e-7 * k);
                }
            rl_image_clear(&image);
            fixture_end(&scene);
        }
}

/* Lights may move between frames: the map follows when it is drawn again. */
static void the_map_follows_the_lights(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    struct rl_image image;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    double seconds = -1.0;
    settings.env_size = 64;
    begin(&scene, v3(0.0, 0.0, 0.0));
    fixture_quad(&scene, v3(2.0, 0.0, 0.0), v3(0.0, 1.0, 0.0), v3(0.0, 0.0, 1.0), 1.0, 1.0, 1.0);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
    for (int i = 0; i < 4; i++)
        scene.light[0].polygon[0].vertex[i].x = -2.0;
    check_ok(rl_gpu_scene_environment(gs, &seconds, &error), &error);
    assert_true(seconds > 0.0);
    check_ok(rl_gpu_scene_read_environment(gs, 0, &image, &error), &error);
    size_t lit;
    assert_in_range(count_wrong(&image, &scene, 1e-6, &lit), 0, 2);
    rl_image_clear(&image);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

static void a_size_that_opengl_refuses_is_an_error(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_gpu_scene *gs;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    begin(&scene, v3(0.0, 0.0, 0.0));
    fixture_quad(&scene, v3(2.0, 0.0, 0.0), v3(0.0, 1.0, 0.0), v3(0.0, 0.0, 1.0), 1.0, 1.0, 1.0);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    plan.settings.env_size = 1 << 20;
    check_fails(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error, RL_ERR_UNAVAILABLE,
                "environment map of 1048576");
    assert_null(gs);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_quad_has_its_solid_angle),
        cmocka_unit_test(the_cpu_draws_the_same_map),
        cmocka_unit_test(the_nearest_light_wins),
        cmocka_unit_test(every_format_keeps_radiance),
        cmocka_unit_test(the_map_follows_the_lights),
        cmocka_unit_test(a_size_that_opengl_refuses_is_an_error),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
