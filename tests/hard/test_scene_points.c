/* The hard scenes in tests/hard/scenes at some points of their objects: every integrator answers with finite numbers, and where two say how far off
 * they may be they agree within that. A finer map brings exhaustive nearer to the reference. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <math.h>

#include "base/simd.h"
#include "hard/scene_files.h"
#include "reference/integrators.h"
#include "scene/scene.h"
#include "support/check.h"

enum { POINTS_PER_OBJECT = 3 };

/* Asked with so much that each call takes some milliseconds. */
static const struct rl_integrate_options asked = {
    .attenuation = true, .tolerance = 1e-6, .max_evaluations = 20000, .seed = 7, .env_size = 64};

struct worst {
    double coarse, fine;     /* root mean square of exhaustive - reference, in parts of the brightest light */
    size_t n, bad, short_of; /* points; of another opinion; whose reference did not reach its tolerance */
};

static double brightest(const struct rl_scene *scene)
{
    double most = 0.0;
    for (size_t i = 0; i < scene->n_lights; i++)
        for (int c = 0; c < 3; c++)
            most = fmax(most, scene->light[i].radiance[c]);
    return most;
}

static struct rl_estimate ask(const char *name, const struct rl_surface *s, const struct rl_ellipsoid *e,
                              const struct rl_light_set *set, int env_size)
{
    struct rl_error error;
    struct rl_estimate estimate;
    struct rl_integrate_options options = asked;
    options.simd = rl_simd_best();
    options.env_size = env_size;
    check_ok(rl_integrator_find(name)->integrate(&estimate, s, e, set, &options, &error), &error);
    for (int c = 0; c < 3; c++)
        if (!isfinite(estimate.value[c]) || !isfinite(estimate.error[c]) || estimate.value[c] < 0.0)
            fail_msg("%s: %.12g +- %.3g at R_r %g, P %.9g %.9g %.9g, N %.9g %.9g %.9g, V %.9g %.9g %.9g",
                     name, estimate.value[c], estimate.error[c], e->rr, s->P.x, s->P.y, s->P.z, s->N.x,
                     s->N.y, s->N.z, s->V.x, s->V.y, s->V.z);
    return estimate;
}

static void say(const char *scene, const char *name, const struct rl_surface *s, double rr,
                const struct rl_estimate *a, const struct rl_estimate *b, int c)
{
    print_error(
        "%s, %s: %.12g +- %.3g, reference %.12g +- %.3g, R_r %g, P %.9g %.9g %.9g N %.9g %.9g %.9g V %.9g "
        "%.9g %.9g\n",
        scene, name, a->value[c], a->error[c], b->value[c], b->error[c], rr, s->P.x, s->P.y, s->P.z, s->N.x,
        s->N.y, s->N.z, s->V.x, s->V.y, s->V.z);
}

/* What takes random numbers or only estimates its error has to be finite. */
static const char *const others[] = {"montecarlo", "vegas", "cubature", "cubature-uv"};

struct place {
    const char *name;
    const struct rl_scene *scene;
    const struct rl_light_set *set;
    double rr, unit; /* the brightest radiance */
};

static void check_point(struct worst *worst, const struct place *place, const struct rl_surface *s)
{
    const struct rl_ellipsoid e = rl_ellipsoid_make(place->rr);
    const struct rl_light_set *set = place->set;
    double unit = place->unit;
    struct rl_estimate reference = ask("reference", s, &e, set, 0);
    for (size_t i = 0; i < sizeof others / sizeof others[0]; i++)
        ask(others[i], s, &e, set, 0);
    struct rl_estimate coarse = ask("exhaustive", s, &e, set, asked.env_size / 4);
    struct rl_estimate fine = ask("exhaustive", s, &e, set, asked.env_size);
    worst->short_of += !reference.converged;
    worst->n++;
    for (int c = 0; c < 3; c++) {
        double off = fabs(fine.value[c] - reference.value[c]);
        worst->coarse += pow((coarse.value[c] - reference.value[c]) / unit, 2.0);
        worst->fine += off / unit * (off / unit);
        if (off <= fine.error[c] + reference.error[c])
            continue;
        say(place->name, "exhaustive", s, place->rr, &fine, &reference, c);
        worst->bad++;
    }
}

/* The normal on the eye's side. */
static struct rl_surface seen_from(rl_vec3 P, rl_vec3 N, rl_vec3 V)
{
    return (struct rl_surface){.P = P, .N = v3_dot(N, V) < 0.0 ? v3_scale(-1.0, N) : N, .V = V};
}

/* From the camera, and from where the light is mirrored to the eye. */
static void check_views(struct worst *worst, const struct place *place, rl_vec3 P, rl_vec3 N)
{
    const struct rl_scene *scene = place->scene;
    struct rl_surface s = seen_from(P, N, v3_normalize(v3_sub(scene->camera.position, P)));
    if (v3_dot(s.V, s.V) > 0.0)
        check_point(worst, place, &s);
    for (size_t i = 0; i < scene->n_lights && i < 2; i++) {
        rl_vec3 L = v3_normalize(v3_sub(scene->light[i].centroid, P));
        rl_vec3 V = v3_reflect(v3_dot(L, N) < 0.0 ? v3_scale(-1.0, v3_reflect(L, N)) : L, N);
        s = seen_from(P, N, v3_normalize(V));
        if (v3_dot(V, V) > 0.0)
            check_point(worst, place, &s);
    }
}

/* At vertices, where lights may stand, and at the middles of triangles. */
static void check_object(struct worst *worst, struct place *place, const struct rl_object *o)
{
    const struct rl_mesh *mesh = &o->mesh;
    size_t step = mesh->n_triangles / POINTS_PER_OBJECT + 1;
    place->rr = place->scene->material[o->material].rr;
    for (size_t i = 0; i < mesh->n_triangles; i += step) {
        const uint32_t *corner = mesh->triangle[i];
        const float *p = mesh->position[corner[0]], *n = mesh->normal[corner[0]];
        rl_vec3 centroid, normal;
        check_views(worst, place, v3((double)p[0], (double)p[1], (double)p[2]),
                    v3_normalize(v3((double)n[0], (double)n[1], (double)n[2])));
        rl_mesh_facet(mesh, i, &centroid, &normal);
        check_views(worst, place, centroid, normal);
    }
}

static struct worst check_scene(const char *name, const char *path)
{
    struct rl_error error;
    struct rl_scene scene;
    struct rl_light_set *set;
    struct worst worst = {0};
    check_ok(rl_scene_load(&scene, path, &error), &error);
    check_ok(rl_light_set_make(&set, scene.light, scene.n_lights, &error), &error);
    struct place place = {name, &scene, set, 1.0, brightest(&scene)};
    for (size_t i = 0; i < scene.n_objects; i++)
        check_object(&worst, &place, &scene.object[i]);
    rl_light_set_free(set);
    rl_scene_clear(&scene);
    worst.coarse = sqrt(worst.coarse / (3.0 * (double)worst.n));
    worst.fine = sqrt(worst.fine / (3.0 * (double)worst.n));
    print_message(
        "%-12s %zu points, %zu reference short of 1e-6, exhaustive off by %.2g at %d, %.2g at %d texels\n",
        name, worst.n, worst.short_of, worst.coarse, asked.env_size / 4, worst.fine, asked.env_size);
    return worst;
}

static void test_points(void **state)
{
    (void)state;
    struct scene_files files;
    size_t bad = 0, nearer = 0, scenes = 0;
    scene_files_list(&files);
    for (size_t i = 0; i < files.n; i++) {
        if (files.refused[i][0])
            continue;
        struct worst worst = check_scene(files.name[i], files.path[i]);
        assert_true(worst.n >= 3);
        bad += worst.bad;
        /* Where lights are as large as texels: of a needle a map sees nothing, however fine. */
        scenes += worst.coarse > 1e-3;
        nearer += worst.coarse > 1e-3 && worst.fine < worst.coarse;
    }
    assert_int_equal(bad, 0);
    print_message("nearer with the finer map: %zu of %zu scenes\n", nearer, scenes);
    assert_true(scenes >= 6 && nearer == scenes);
}

/* An eye ever closer to the horizon: the weight shrinks to a spot as high as V and R_r times as thin, which no texel resolves. */
static void test_grazing(void **state)
{
    (void)state;
    static const double height[] = {1e-2, 1e-4, 1e-6, 1e-9, 1e-100};
    static const double ratio[] = {1.0, 10.0, 300.0};
    static const rl_vec3 vertex[] = {
        {-10.0, -10.0, -13.0}, {10.0, -10.0, -13.0}, {10.0, 10.0, -13.0}, {-10.0, 10.0, -13.0}};
    const rl_vec3 *const vertices[] = {vertex};
    const size_t n_vertices[] = {4};
    struct rl_error error;
    struct rl_light_set *set;
    check_ok(rl_light_set_from_polygons(&set, vertices, n_vertices, 1, &error), &error);
    for (size_t r = 0; r < sizeof ratio / sizeof ratio[0]; r++)
        for (size_t i = 0; i < sizeof height / sizeof height[0]; i++) {
            const struct rl_ellipsoid e = rl_ellipsoid_make(ratio[r]);
            const struct rl_surface s = {
                .P = {0.1, 0.0, -2.0}, .N = {0.0, 1.0, 0.0}, .V = v3_normalize(v3(-0.11, height[i], 0.99))};
            struct rl_estimate reference = ask("reference", &s, &e, set, 0),
                               map = ask("exhaustive", &s, &e, set, asked.env_size);
            check_near(map.value[0], reference.value[0], map.error[0] + reference.error[0]);
        }
    rl_light_set_free(set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_points),
        cmocka_unit_test(test_grazing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
