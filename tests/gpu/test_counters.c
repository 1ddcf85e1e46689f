/* What the GPU layer did is what the plan says, and without an effect it is just that effect's share less: for every effect of the table. */
#include "gpu/context.h"
#include "gpu/fixture.h"
#include "studies/features.h"

enum { WIDTH = 64, HEIGHT = 48 };

/* Of a picture: four components. */
#define IMAGE_BYTES ((size_t)WIDTH * HEIGHT * 4 * sizeof(float))

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

/* A ball for each effect, in a row, and one with a sampled highlight, as those with a factor on it have; a shaped light and a point light. `without`: a row that none has. */
static void begin_scene(struct rl_scene *scene, size_t without)
{
    static char *const name = "material";
    fixture_begin(scene, WIDTH, HEIGHT);
    free(scene->material);
    free(scene->object);
    scene->material = calloc(rl_n_effects + 1, sizeof *scene->material);
    scene->object = calloc(rl_n_effects + 1, sizeof *scene->object);
    assert_true(scene->material && scene->object);
    fixture_camera(scene, v3(0.0, 0.0, 12.0), v3(0.0, 0.0, 0.0), 60.0);
    for (size_t row = 0; row <= rl_n_effects; row++) {
        struct rl_material *m = &scene->material[scene->n_materials++];
        m->name = name;
        m->rr = 10.0;
        m->method = row == rl_n_effects || rl_effects[row]->factor ? "random" : NULL;
        for (int c = 0; c < 3; c++)
            m->specular[c] = 1.0;
        if (row < rl_n_effects && row != without)
            rl_feature_give(m, rl_effects[row]);
        fixture_object(scene, RL_SHAPE_SPHERE, 4, 0.4, v3((double)row - 0.5 * (double)rl_n_effects, 0.0, 0.0),
                       (int)row);
        scene->object[row].name = name;
    }
    fixture_quad(scene, v3(-2.0, 2.0, 3.0), v3(0.8, 0.8, 0.0), v3(0.5, -0.5, 0.5), 2.0, 1.5, 1.0);
    fixture_source(scene, false, v3(1.0, 2.0, 3.0), 1.0, 1.0, 0.5);
}

struct done {
    struct rl_plan plan;
    struct rl_gpu_counters made, frame;
    struct rl_image image;
};

static void clear(struct done *done)
{
    rl_plan_clear(&done->plan);
    rl_image_clear(&done->image);
}

static void render(struct done *done, const struct rl_scene *scene)
{
    struct rl_error error;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    struct rl_gpu_scene *gs;
    double seconds;
    settings.env_size = 16;
    settings.normal_size = 64;
    check_ok(rl_plan_make(&done->plan, scene, &settings, &error), &error);
    check_ok(rl_gpu_scene_make(&gs, gpu, scene, &done->plan, &error), &error);
    done->made = rl_gpu_scene_counters(gs);
    rl_gpu_scene_reset_counters(gs);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    done->frame = rl_gpu_scene_counters(gs);
    check_ok(rl_gpu_scene_read(gs, &done->image, &error), &error);
    rl_gpu_scene_free(gs);
}

/* On a context that has kept nothing of what was drawn before: everything is made. */
static void render_anew(struct done *done, const struct rl_scene *scene)
{
    rl_kept_clear(&gpu->kept, &gpu->gl);
    render(done, scene);
    assert_int_equal(done->made.programs_kept + done->made.textures_kept, 0);
}

static size_t count_modules(const struct rl_plan *plan)
{
    size_t n = 0;
    for (size_t i = 0; i < plan->n_programs; i++)
        n += plan->program[i].n_modules;
    return n;
}

/* The plan against what was counted. */
static void check_plan(const struct done *done, const struct rl_scene *scene)
{
    const struct rl_plan *plan = &done->plan;
    assert_int_equal(done->made.programs, plan->n_programs);
    assert_int_equal(done->made.modules, count_modules(plan));
    assert_int_equal(done->made.textures, plan->n_normal_maps + plan->n_environments);
    assert_int_equal(done->made.draws, 6 * plan->n_environments);
    assert_int_equal(done->made.renderbuffers, 2 + (plan->n_environments > 0));
    size_t draws = 0;
    for (size_t i = 0; i < scene->n_objects; i++)
        draws += 1 + (rl_plan_of_object(plan, scene, i)->highlight_program >= 0);
    assert_int_equal(done->frame.draws, draws);
    assert_int_equal(done->frame.textures + done->frame.programs + done->frame.modules, 0);
    assert_int_equal(done->frame.bytes_uploaded + done->frame.renderbuffers, 0);
}

/* The same scene once more is in use as before, but compiles no program, uploads no normal map and allocates no environment map. */
static void test_kept(void **state)
{
    (void)state;
    const size_t map_bytes = (size_t)64 * 64 * 4;
    struct rl_scene scene;
    struct done first, again;
    begin_scene(&scene, rl_n_effects);
    render_anew(&first, &scene);
    render(&again, &scene);
    check_plan(&again, &scene);
    assert_int_equal(again.made.programs_kept, again.made.programs);
    assert_int_equal(again.made.textures_kept, again.plan.n_normal_maps + again.plan.n_environments);
    assert_int_equal(first.made.bytes_uploaded - again.made.bytes_uploaded,
                     again.plan.n_normal_maps * map_bytes);
    assert_int_equal(first.made.bytes_kept, 0);
    assert_int_equal(again.made.bytes_uploaded + again.made.bytes_kept, first.made.bytes_uploaded);
    assert_memory_equal(first.image.data, again.image.data, IMAGE_BYTES);
    clear(&again);
    fixture_end(&scene);
    clear(&first);
}

/* A kept program stands only for the same: after scenes that have every other effect the picture is that of a new context, and only
 * programs that no scene had before are new. */
static void test_kept_among_others(void **state)
{
    (void)state;
    struct done anew, kept;
    for (size_t row = 0; row < rl_n_effects; row++) {
        struct rl_scene scene;
        struct done other;
        begin_scene(&scene, (row + 1) % rl_n_effects);
        render_anew(&other, &scene);
        fixture_end(&scene);
        begin_scene(&scene, row);
        render(&kept, &scene);
        render_anew(&anew, &scene);
        assert_true(kept.made.programs_kept < kept.made.programs);
        assert_true(kept.made.programs_kept > 0);
        assert_memory_equal(anew.image.data, kept.image.data, IMAGE_BYTES);
        assert_memory_not_equal(other.image.data, kept.image.data, IMAGE_BYTES);
        clear(&other);
        clear(&kept);
        clear(&anew);
        fixture_end(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_kept), cmocka_unit_test(test_kept_among_others)};
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
