/* What objects have in common is uploaded and drawn once, and changes no pixel by a bit. */
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

enum { BALL, LIKE_IT, TURNED, COARSER, RING, COPY, OBJECTS };

/* A ball; one like it elsewhere and larger; one with other normals; one of other triangles; a ring about the first; the first again. */
static void begin_scene(struct rl_scene *scene)
{
    fixture_begin(scene, 64, 48);
    fixture_camera(scene, v3(0.0, 2.0, 7.0), v3(0.0, 0.0, 0.0), 40.0);
    int paint = fixture_material(scene, 20.0, 0.05, 0.5, 0.8, "random");
    fixture_object(scene, RL_SHAPE_SPHERE, 8, 0.5, v3(0.0, 0.25, 0.0), paint);
    fixture_object(scene, RL_SHAPE_SPHERE, 8, 0.8, v3(-2.0, 0.3, 0.0), paint);
    fixture_object(scene, RL_SHAPE_SPHERE, 8, 0.5, v3(2.0, 0.3, 0.0), paint);
    fixture_object(scene, RL_SHAPE_SPHERE, 7, 0.5, v3(0.0, -1.0, 0.5), paint);
    fixture_object(scene, RL_SHAPE_TORUS, 8, 1.0, v3(0.0, 0.25, 0.0), paint);
    fixture_object(scene, RL_SHAPE_SPHERE, 8, 0.5, v3(0.0, 0.25, 0.0), paint);
    struct rl_mesh *turned = &scene->object[TURNED].mesh;
    for (size_t i = 0; i < turned->n_vertices; i++) {
        float y = turned->normal[i][1];
        turned->normal[i][1] = turned->normal[i][2];
        turned->normal[i][2] = y;
    }
    fixture_quad(scene, v3(-1.0, 2.5, 2.0), v3(0.6, 0.0, 0.0), v3(0.0, 0.6, 0.2), 2.0, 1.5, 1.0);
}

/* The plan as it would be if nothing was shared. */
static void unshare(struct rl_plan *plan)
{
    plan->n_environments = 0;
    for (size_t i = 0; i < OBJECTS; i++) {
        plan->environment[i] = (int)plan->n_environments++;
        for (int part = 0; part < RL_MESH_PARTS; part++)
            plan->object[i].mesh_from[part] = i;
    }
}

static struct rl_gpu_counters render(struct rl_image *image, const struct rl_scene *scene,
                                     const struct rl_plan *plan)
{
    struct rl_error error;
    struct rl_gpu_scene *gs;
    double seconds;
    check_ok(rl_gpu_scene_make(&gs, gpu, scene, plan, &error), &error);
    struct rl_gpu_counters made = rl_gpu_scene_counters(gs);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(gs, image, &error), &error);
    rl_gpu_scene_free(gs);
    return made;
}

/* Vectors and triangles of three integers or floats. */
static const size_t SIZE = 12;

static void test_share(void **state)
{
    (void)state;
    static const size_t from[OBJECTS][RL_MESH_PARTS] = {
        [BALL] = {BALL, BALL, BALL},       [LIKE_IT] = {BALL, BALL, LIKE_IT},
        [TURNED] = {BALL, TURNED, TURNED}, [COARSER] = {COARSER, COARSER, COARSER},
        [RING] = {RING, RING, RING},       [COPY] = {BALL, BALL, BALL},
    };
    static const int environment[OBJECTS] = {0, 1, 2, 3, 0, 0};
    for (int interpolation = 0; interpolation < RL_INTERPOLATIONS; interpolation++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_image shared, apart;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        settings.interpolation = interpolation;
        settings.env_size = 32;
        settings.normal_size = 64;
        begin_scene(&scene);
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        for (size_t i = 0; i < OBJECTS; i++)
            assert_memory_equal(plan.object[i].mesh_from, from[i], sizeof from[i]);
        assert_memory_equal(plan.environment, environment, sizeof environment);
        assert_int_equal(plan.n_environments, 4);
        render(&shared, &scene, &plan); /* bakes the normal map, which is kept */
        rl_image_clear(&shared);
        struct rl_gpu_counters with = render(&shared, &scene, &plan);
        unshare(&plan);
        struct rl_gpu_counters without = render(&apart, &scene, &plan);
        assert_int_equal(without.textures - with.textures, 2);
        assert_int_equal(without.draws - with.draws, 2 * 6);
        const struct rl_mesh *ball = &scene.object[BALL].mesh;
        size_t saved = without.bytes_uploaded - with.bytes_uploaded;
        size_t expected = SIZE * (3 * ball->n_triangles + 3 * ball->n_vertices);
        if (interpolation == RL_INTERPOLATION_CONSTANT)
            assert_true(saved > expected); /* facets have more vertices, and vectors more for each */
        else
            assert_int_equal(saved, expected);
        assert_memory_equal(shared.data, apart.data, sizeof(float) * 4 * 64 * 48);
        rl_image_clear(&shared);
        rl_image_clear(&apart);
        rl_plan_clear(&plan);
        fixture_end(&scene);
    }
}

/* What is not drawn is no other's part, and triangles that are shaded as a whole are not those of a smooth surface. */
static void test_not_shared(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    const struct rl_settings settings = RL_SETTINGS_DEFAULT;
    begin_scene(&scene);
    scene.object[BALL].centre = v3(0.0, 0.0, 50.0); /* for the planner, behind the camera */
    scene.object[LIKE_IT].material = fixture_material(&scene, 20.0, 0.05, 0.5, 0.8, "random");
    scene.material[1].interpolation = RL_INTERPOLATION_CONSTANT;
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    assert_false(plan.object[BALL].drawn);
    for (int part = 0; part < RL_MESH_PARTS; part++) {
        assert_int_equal(plan.object[LIKE_IT].mesh_from[part], LIKE_IT);
        assert_int_equal(plan.object[TURNED].mesh_from[part], TURNED);
    }
    assert_int_equal(plan.object[COPY].mesh_from[RL_MESH_TRIANGLES], TURNED);
    assert_int_equal(plan.environment[BALL], -1);
    assert_int_equal(plan.environment[RING], plan.environment[COPY]);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_share), cmocka_unit_test(test_not_shared)};
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
