/* What is drawn is what the C functions compute at the point where a ray caster finds it. */
#include <stdbool.h>

#include "gpu/fixture.h"
#include "gpu/program.h"
#include "model/attenuation.h"

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

/* Moeller and Trumbore 1997, front faces only; a and b weigh the second and third vertex. */
static bool meet(const struct rl_mesh *mesh, size_t triangle, rl_vec3 from, rl_vec3 direction, double *t,
                 double *a, double *b)
{
    rl_vec3 v[3];
    for (int i = 0; i < 3; i++) {
        const float *p = mesh->position[mesh->triangle[triangle][i]];
        v[i] = v3(p[0], p[1], p[2]);
    }
    rl_vec3 e1 = v3_sub(v[1], v[0]);
    rl_vec3 e2 = v3_sub(v[2], v[0]);
    rl_vec3 p = v3_cross(direction, e2);
    double det = v3_dot(e1, p);
    if (!(det > 0.0))
        return false;
    rl_vec3 d = v3_sub(from, v[0]);
    rl_vec3 q = v3_cross(d, e1);
    *a = v3_dot(d, p) / det;
    *b = v3_dot(direction, q) / det;
    *t = v3_dot(e2, q) / det;
    return *a >= 0.0 && *b >= 0.0 && *a + *b <= 1.0 && *t > 0.0;
}

/* The point that the pixel's centre shows: its object or -1. */
static int cast(struct rl_surface *s, const struct rl_scene *scene, int x, int y)
{
    rl_vec3 direction = rl_camera_ray(&scene->camera, scene->width, scene->height, x, y);
    rl_vec3 from = scene->camera.position;
    double nearest = INFINITY;
    int found = -1;
    for (size_t o = 0; o < scene->n_objects; o++) {
        const struct rl_mesh *mesh = &scene->object[o].mesh;
        for (size_t i = 0; i < mesh->n_triangles; i++) {
            double t, a, b;
            if (!meet(mesh, i, from, direction, &t, &a, &b) || t >= nearest)
                continue;
            const double w[3] = {1.0 - a - b, a, b};
            rl_vec3 N = v3(0.0, 0.0, 0.0);
            for (int k = 0; k < 3; k++) {
                const float *n = mesh->normal[mesh->triangle[i][k]];
                N = v3_madd(N, w[k], v3(n[0], n[1], n[2]));
            }
            nearest = t;
            found = (int)o;
            *s = (struct rl_surface){v3_madd(from, t, direction), v3_normalize(N), v3_scale(-1.0, direction)};
        }
    }
    return found;
}

/* A pixel's colour less its highlight, and the highlight too if the method is one of points. */
static void shade(double rgb[3], const struct rl_surface *s, const struct rl_plan_material *m,
                  const struct rl_scene *scene)
{
    struct rl_error error;
    struct rl_lights lights;
    double params[RL_PLAN_EFFECTS_MAX][RL_EFFECT_PARAMS][4];
    double part[3];
    const struct rl_material *material = &scene->material[m->material];
    check_ok(rl_scene_lights_make(&lights, scene, &error), &error);
    for (size_t i = 0; i < m->n_effects; i++)
        m->effect[i]->pack(rl_effect_given(material, m->effect[i]), params[i]);
    rl_effects_shade(m->effect, m->n_effects, params, s, &lights, rgb);
    if (m->method && m->method->shade && v3_dot(s->N, s->V) > 0.0) {
        struct rl_ellipsoid e = rl_ellipsoid_make(m->rr);
        m->method->pack(&e, params[0]);
        m->method->shade(s, lights.point, lights.n_points, params[0], part);
        for (int c = 0; c < 3; c++)
            rgb[c] += material->specular[c] * part[c];
    }
    rl_scene_lights_clear(&lights);
}

/* Two objects, one partly behind the other, three shaped lights, a point and a parallel one. */
static void begin_scene(struct rl_scene *scene, const char *method, double rr)
{
    fixture_begin(scene, 96, 72);
    fixture_camera(scene, v3(0.5, 0.8, 4.0), v3(0.0, 0.0, 0.0), 35.0);
    fixture_object(scene, RL_SHAPE_SPHERE, 10, 0.8, v3(-0.4, 0.0, 0.0),
                   fixture_material(scene, rr, 0.05, 0.6, 0.8, method));
    fixture_object(scene, RL_SHAPE_TORUS, 10, 0.6, v3(0.6, 0.1, -0.4),
                   fixture_material(scene, rr, 0.0, 0.3, 0.5, method));
    fixture_quad(scene, v3(-2.0, 2.0, 3.0), v3(0.8, 0.8, 0.0), v3(0.5, -0.5, 0.5), 2.0, 1.5, 1.0);
    fixture_quad(scene, v3(2.0, 0.5, 2.0), v3(0.1, 0.8, 0.0), v3(0.5, 0.0, -0.5), 0.2, 1.0, 3.0);
    const rl_vec3 triangle[3] = {v3(0.0, 3.0, 0.0), v3(1.0, 3.0, 0.2), v3(0.3, 3.5, 1.0)};
    fixture_light(scene, triangle, 3, 5.0, 5.0, 5.0);
    fixture_source(scene, false, v3(1.0, -1.0, 1.5), 1.0, 0.5, 0.2);
    fixture_source(scene, true, v3(-2.0, -1.0, 0.5), 0.3, 0.6, 0.2);
}

/* Every pixel against the C functions at the point where the ray caster hits. `outliers`: pixels at
 * silhouettes, where a rasteriser with 1/256 of a pixel may decide otherwise. */
static void compare_with_c(const char *method, double rr, double tolerance, size_t outliers)
{
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_image image;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    begin_scene(&scene, method, rr);
    fixture_render(&image, gpu, &scene, &settings);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    size_t off = 0;
    size_t foreground = 0;
    double worst = 0.0;
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++) {
            struct rl_surface s;
            double expected[4] = {0.0, 0.0, 0.0, 0.0};
            const float *found = rl_image_pixel(&image, x, y);
            int object = cast(&s, &scene, x, y);
            if (object >= 0) {
                shade(expected, &s, rl_plan_of_object(&plan, &scene, (size_t)object), &scene);
                expected[3] = 1.0;
                foreground++;
            }
            double error_here = 0.0;
            for (int c = 0; c < 4; c++)
                error_here = fmax(error_here, fabs(found[c] - expected[c]));
            if (error_here > tolerance)
                off++;
            else
                worst = fmax(worst, error_here);
        }
    print_message("%s, R_r %g: %zu of %zu pixels off, the others within %.1e\n", method, rr, off, foreground,
                  worst);
    assert_true(foreground > 1500);
    assert_in_range(off, 0, outliers);
    rl_plan_clear(&plan);
    rl_image_clear(&image);
    fixture_end(&scene);
}

static void effects_agree_with_c(void **state)
{
    (void)state;
    compare_with_c(NULL, 10.0, 1e-5, 4);
}

static void plain_agrees_with_c(void **state)
{
    (void)state;
    compare_with_c("plain", 3.0, 1e-4, 4);
    compare_with_c("plain", 30.0, 2e-3, 4);
}

/* The microfacet that sample i of a pixel has, in the world and at its length. `row` counts from the bottom.
 * */
static struct rl_microfacet sample(const struct rl_plan *plan, const struct rl_ellipsoid *e, int i, int x,
                                   int row)
{
    const struct rl_method *method = plan->material[0].method;
    if (method->needs_pattern) {
        struct rl_microfacet pattern[RL_SAMPLES_MAX];
        method->pattern(e, plan->material[0].samples, pattern);
        return pattern[i];
    }
    unsigned size = (unsigned)plan->settings.normal_size;
    unsigned at = (unsigned)i * rl_normal_map_step((int)size) & (size * size - 1);
    unsigned column = ((unsigned)x + at % size) % size;
    unsigned line = ((unsigned)row + at / size) % size;
    struct rl_microfacet h = method->texel(e, plan->settings.seed, line * size + column);
    h.weight = 1.0 / plan->material[0].samples;
    return h;
}

/* L_o for L_e = 1: the sum of weights times G. */
static double furnace(const struct rl_plan *plan, const struct rl_surface *s, const struct rl_ellipsoid *e,
                      int x, int row)
{
    struct rl_frame frame = rl_frame_make(plan->settings.frame, s->N);
    double n_v = v3_dot(s->N, s->V);
    double sum = 0.0;
    if (!(n_v > 0.0))
        return 0.0;
    for (int i = 0; i < plan->material[0].samples; i++) {
        struct rl_microfacet h = sample(plan, e, i, x, row);
        rl_vec3 H = v3_madd(v3_madd(v3_scale(h.x, frame.N), h.y, frame.T), h.z, frame.B);
        H = v3_normalize(H);
        rl_vec3 L = v3_reflect(s->V, H);
        double g = rl_attenuation(v3_dot(s->N, H), n_v, v3_dot(s->N, L), v3_dot(s->V, H));
        sum += h.weight * (plan->settings.attenuation ? g : 1.0);
    }
    return sum;
}

/* With light all round only G is left, so that its every factor, the frame and the address of each normal
 * show. */
static void sampled_methods_agree_with_c_in_a_furnace(void **state)
{
    (void)state;
    static const struct {
        const char *method;
        int samples;
        double rr;
        enum rl_frame_kind frame;
        bool attenuation;
    } rows[] = {
        {"regular", 13, 10.0, RL_FRAME_ORTHONORMAL, true}, {"regular", 13, 1.0, RL_FRAME_ORTHONORMAL, true},
        {"regular", 64, 2.0, RL_FRAME_PRINTED, true},      {"regular", 7, 2.0, RL_FRAME_ORTHONORMAL, false},
        {"random", 1, 2.0, RL_FRAME_ORTHONORMAL, true},    {"random", 4, 10.0, RL_FRAME_ORTHONORMAL, true},
        {"random", 64, 1.5, RL_FRAME_ORTHONORMAL, true},   {"random", 4, 1.5, RL_FRAME_PRINTED, true},
        {"random", 16, 1.5, RL_FRAME_ORTHONORMAL, false},
    };
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_image image;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.samples = rows[r].samples;
        settings.frame = rows[r].frame;
        settings.attenuation = rows[r].attenuation;
        settings.normal_bits = RL_NORMAL_BITS_FLOAT;
        settings.normal_size = 64;
        settings.env_size = 16;
        settings.seed = 3;
        fixture_furnace(&scene, rows[r].method, rows[r].rr);
        fixture_render(&image, gpu, &scene, &settings);
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        struct rl_ellipsoid e = rl_ellipsoid_make(rows[r].rr);
        double worst = 0.0;
        size_t off = 0;
        for (int y = 0; y < image.height; y++)
            for (int x = 0; x < image.width; x++) {
                struct rl_surface s;
                double found = rl_image_pixel(&image, x, y)[0];
                double expected =
                    cast(&s, &scene, x, y) >= 0 ? furnace(&plan, &s, &e, x, image.height - 1 - y) : 0.0;
                double here = fabs(found - expected);
                off += here > 1e-4;
                if (here <= 1e-4)
                    worst = fmax(worst, here);
            }
        print_message("%s %d: %zu pixels off, the others within %.1e\n", rows[r].method, rows[r].samples, off,
                      worst);
        assert_in_range(off, 0, 2);
        rl_plan_clear(&plan);
        rl_image_clear(&image);
        fixture_end(&scene);
    }
}

static double image_sum(const struct rl_image *image, int channel)
{
    double sum = 0.0;
    for (int i = 0; i < image->width * image->height; i++)
        sum += image->data[4 * i + channel];
    return sum;
}

static void many_random_samples_approach_many_regular_ones(void **state)
{
    (void)state;
    static const double ratios[] = {2.0, 10.0, 50.0};
    for (size_t i = 0; i < sizeof ratios / sizeof ratios[0]; i++) {
        struct rl_scene scene;
        struct rl_image random;
        struct rl_image regular;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.samples = 1024;
        settings.normal_bits = RL_NORMAL_BITS_FLOAT;
        fixture_sphere(&scene, 96, 72, "random", ratios[i]);
        memset(scene.material[0].effect, 0, sizeof scene.material[0].effect);
        fixture_render(&random, gpu, &scene, &settings);
        settings.method = "regular";
        fixture_render(&regular, gpu, &scene, &settings);
        double a = image_sum(&random, 0);
        double b = image_sum(&regular, 0);
        print_message("R_r %g: random %.3f, regular %.3f\n", ratios[i], a, b);
        assert_true(a > 10.0);
        /* The pattern leaves out the tails; the rest of the bound is noise. */
        check_relative(b, a, 0.05);
        rl_image_clear(&random);
        rl_image_clear(&regular);
        fixture_end(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(effects_agree_with_c),
        cmocka_unit_test(plain_agrees_with_c),
        cmocka_unit_test(sampled_methods_agree_with_c_in_a_furnace),
        cmocka_unit_test(many_random_samples_approach_many_regular_ones),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
