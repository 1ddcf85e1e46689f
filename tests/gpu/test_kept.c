/* What the context keeps from scene to scene: made once, the same pictures as made anew, and no more memory than its share. */
#include "gpu/context.h"
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

static struct rl_settings settings_of(int samples, int bits, uint64_t seed)
{
    struct rl_settings s = RL_SETTINGS_DEFAULT;
    s.samples = samples;
    s.normal_bits = bits;
    s.normal_size = 64;
    s.seed = seed;
    return s;
}

/* The same settings once more, after others, and on a context that has kept nothing. */
static void pictures_are_those_of_a_new_context(void **state)
{
    (void)state;
    static const struct {
        const char *method;
        int samples, bits;
        uint64_t seed;
        double rr;
    } row[] = {
        {"random", 4, 8, 1, 30.0}, {"random", 4, 8, 2, 30.0},  {"random", 4, 10, 1, 30.0},
        {"random", 5, 8, 1, 30.0}, {"random", 4, 8, 1, 100.0}, {"regular", 13, 8, 1, 30.0},
        {"plain", 1, 8, 1, 30.0},  {"random", 4, 8, 1, 30.0},
    };
    enum { ROWS = sizeof row / sizeof row[0] };
    struct rl_image kept[ROWS];
    for (int i = 0; i < ROWS; i++) {
        struct rl_scene scene;
        struct rl_settings s = settings_of(row[i].samples, row[i].bits, row[i].seed);
        fixture_sphere(&scene, 48, 36, row[i].method, row[i].rr);
        fixture_render(&kept[i], gpu, &scene, &s);
        fixture_end(&scene);
    }
    size_t bytes = (size_t)48 * 36 * 4 * sizeof(float);
    for (int i = 1; i < ROWS - 1; i++)
        assert_memory_not_equal(kept[0].data, kept[i].data, bytes);
    assert_memory_equal(kept[0].data, kept[ROWS - 1].data, bytes);
    rl_gpu_close(gpu);
    for (int i = 0; i < ROWS; i++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_image fresh;
        struct rl_settings s = settings_of(row[i].samples, row[i].bits, row[i].seed);
        check_ok(rl_gpu_open(&gpu, "auto", &error), &error);
        fixture_sphere(&scene, 48, 36, row[i].method, row[i].rr);
        fixture_render(&fresh, gpu, &scene, &s);
        assert_memory_equal(kept[i].data, fresh.data, bytes);
        rl_image_clear(&fresh);
        rl_image_clear(&kept[i]);
        fixture_end(&scene);
        rl_gpu_close(gpu);
    }
    assert_int_equal(open_gpu(NULL), 0);
}

/* A second scene of the same plan uploads no normal map, and leaves the first as it was when it goes. */
static void two_scenes_share(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_settings s = settings_of(4, 8, 7);
    struct rl_gpu_scene *a, *b;
    struct rl_image before, after;
    double seconds;
    fixture_sphere(&scene, 48, 36, "random", 30.0);
    check_ok(rl_plan_make(&plan, &scene, &s, &error), &error);
    check_ok(rl_gpu_scene_make(&a, gpu, &scene, &plan, &error), &error);
    check_ok(rl_gpu_scene_frame(a, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(a, &before, &error), &error);
    check_ok(rl_gpu_scene_make(&b, gpu, &scene, &plan, &error), &error);
    assert_int_equal(rl_gpu_scene_counters(a).bytes_uploaded - rl_gpu_scene_counters(b).bytes_uploaded,
                     64 * 64 * 4);
    check_ok(rl_gpu_scene_reseed(b, 8, &error), &error);
    check_ok(rl_gpu_scene_frame(b, &seconds, &error), &error);
    rl_gpu_scene_free(b);
    check_ok(rl_gpu_scene_frame(a, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(a, &after, &error), &error);
    assert_memory_equal(before.data, after.data, (size_t)48 * 36 * 4 * sizeof(float));
    rl_image_clear(&before);
    rl_image_clear(&after);
    rl_gpu_scene_free(a);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

/* Warming up changes no frame and no counter. */
static void warm_up_changes_nothing(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_settings s = settings_of(4, 8, 1);
    struct rl_gpu_scene *gs;
    struct rl_image before, after;
    double seconds;
    s.margin_kind = RL_MARGIN_VALUE;
    s.margin = 0.5;
    fixture_sphere(&scene, 48, 36, "random", 30.0);
    check_ok(rl_plan_make(&plan, &scene, &s, &error), &error);
    check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(gs, &before, &error), &error);
    size_t draws = rl_gpu_scene_counters(gs).draws;
    check_ok(rl_gpu_scene_warm_up(gs, &error), &error);
    assert_int_equal(rl_gpu_scene_counters(gs).draws, draws);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    check_ok(rl_gpu_scene_read(gs, &after, &error), &error);
    assert_memory_equal(before.data, after.data, (size_t)48 * 36 * 4 * sizeof(float));
    rl_image_clear(&before);
    rl_image_clear(&after);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
    fixture_end(&scene);
}

/* Objects without users go, the one used least lately first; those in use stay, whatever they take. */
static void memory_is_bounded(void **state)
{
    (void)state;
    struct rl_kept kept = {0};
    const size_t large = (size_t)80 << 20;
    GLuint id[3];
    gpu->gl.GenTextures(3, id);
    for (uint64_t k = 0; k < 3; k++)
        assert_int_equal(rl_kept_add(&kept, &gpu->gl, RL_KEPT_TEXTURE, k + 1, id[k], large, NULL), RL_OK);
    assert_int_equal(kept.n, 3);
    rl_kept_release(&kept, &gpu->gl, RL_KEPT_TEXTURE, id[1]);
    assert_int_equal(kept.n, 2); /* at once: the others alone are more than the share less one */
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_TEXTURE, 2), 0);
    rl_kept_release(&kept, &gpu->gl, RL_KEPT_TEXTURE, id[0]);
    rl_kept_release(&kept, &gpu->gl, RL_KEPT_TEXTURE, id[2]);
    assert_int_equal(kept.n, 2);
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_TEXTURE, 1), id[0]); /* used again: now the latest */
    rl_kept_release(&kept, &gpu->gl, RL_KEPT_TEXTURE, id[0]);
    GLuint one;
    gpu->gl.GenTextures(1, &one);
    assert_int_equal(rl_kept_add(&kept, &gpu->gl, RL_KEPT_TEXTURE, 9, one, large, NULL), RL_OK);
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_TEXTURE, 3), 0);
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_TEXTURE, 1), id[0]);
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_PROGRAM, 1), 0); /* another kind */
    rl_kept_clear(&kept, &gpu->gl);
    assert_int_equal(kept.n, 0);
}

/* A texture whose contents nobody counts on goes from one user to the next, never to two at once. */
static void storage_has_one_user(void **state)
{
    (void)state;
    struct rl_kept kept = {0};
    GLuint id;
    gpu->gl.GenTextures(1, &id);
    assert_int_equal(rl_kept_add(&kept, &gpu->gl, RL_KEPT_STORAGE, 1, id, 1024, NULL), RL_OK);
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_STORAGE, 1), 0);
    rl_kept_release(&kept, &gpu->gl, RL_KEPT_STORAGE, id);
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_STORAGE, 2), 0);
    assert_int_equal(rl_kept_take(&kept, RL_KEPT_STORAGE, 1), id);
    rl_kept_clear(&kept, &gpu->gl);
}

/* A ball that mirrors one light, which is at x. */
static void render_lit_from(struct rl_image *image, double x)
{
    struct rl_scene scene;
    struct rl_settings s = settings_of(4, 8, 1);
    fixture_begin(&scene, 48, 36);
    fixture_camera(&scene, v3(0.0, 0.0, 4.0), v3(0.0, 0.0, 0.0), 32.0);
    fixture_object(&scene, RL_SHAPE_SPHERE, 32, 1.0, v3(0.0, 0.0, 0.0),
                   fixture_material(&scene, 30.0, 0.02, 0.3, 1.0, "random"));
    fixture_quad(&scene, v3(x, 2.0, 3.0), v3(0.8, 0.0, 0.0), v3(0.0, 0.8, 0.0), 2.0, 1.5, 1.0);
    fixture_render(image, gpu, &scene, &s);
    fixture_end(&scene);
}

/* An environment map shows nothing of the lights that its memory showed before. */
static void environment_maps_are_drawn_anew(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_image left, right, fresh;
    const size_t bytes = (size_t)48 * 36 * 4 * sizeof(float);
    render_lit_from(&left, -2.0);
    render_lit_from(&right, 2.0);
    assert_memory_not_equal(left.data, right.data, bytes);
    rl_gpu_close(gpu);
    check_ok(rl_gpu_open(&gpu, "auto", &error), &error);
    render_lit_from(&fresh, 2.0);
    assert_memory_equal(right.data, fresh.data, bytes);
    rl_image_clear(&left);
    rl_image_clear(&right);
    rl_image_clear(&fresh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_scenes_share),
        cmocka_unit_test(warm_up_changes_nothing),
        cmocka_unit_test(memory_is_bounded),
        cmocka_unit_test(storage_has_one_user),
        cmocka_unit_test(environment_maps_are_drawn_anew),
        cmocka_unit_test(pictures_are_those_of_a_new_context),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
