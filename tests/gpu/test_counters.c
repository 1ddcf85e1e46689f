/* What the GPU layer did is what the plan says, and without an effect it is just that effect's share less: for every effect of the table. */
#include "gpu/context.h"
#include "gpu/fixture.h"

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

/* Every coefficient 0.5, everything required at its least, choices at their first. */
static void give(struct rl_material *material, const struct rl_effect *e)
{
    double *value = rl_effect_give(material, e);
    for (size_t k = 0; e->param[k].help; k++) {
        const struct rl_effect_param *p = &e->param[k];
        for (int c = 0; c < (p->kind == RL_EFFECT_COLOUR ? 3 : 1); c++, value++)
            if (p->coefficient && !isnan(p->absent[c]))
                *value = 0.5;
            else if (p->required)
                *value = fmax(0.5, p->low);
    }
}

/* Combinations that a descriptor's own check refuses are completed: the reflectance of cook-torrance, the c of goldman. */
static void complete(struct rl_material *material, const struct rl_effect *e)
{
    double *value = NULL;
    for (size_t row = 0; row < rl_n_effects; row++)
        value = rl_effects[row] == e ? material->effect[row].value : value;
    const char *key = NULL;
    if (!e->check || !e->check(value, &key))
        return;
    for (size_t k = 0; e->param[k].help; k++)
        if (e->param[k].key && strcmp(e->param[k].key, key) == 0)
            for (int c = 0; c < (e->param[k].kind == RL_EFFECT_COLOUR ? 3 : 1); c++)
                value[rl_effect_value_of(e, k) + (size_t)c] = 0.5;
    assert_null(e->check(value, &key));
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
        if (row < rl_n_effects && row != without) {
            give(m, rl_effects[row]);
            complete(m, rl_effects[row]);
        }
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

static bool has_module(const struct rl_plan *plan, const char *module)
{
    for (size_t i = 0; i < plan->n_programs; i++)
        for (size_t k = 0; k < plan->program[i].n_modules; k++)
            if (strcmp(plan->program[i].module[k], module) == 0)
                return true;
    return false;
}

/* The plan against what was counted. */
static void check_plan(const struct done *done, const struct rl_scene *scene)
{
    const struct rl_plan *plan = &done->plan;
    assert_int_equal(done->made.programs, plan->n_programs);
    assert_int_equal(done->made.modules, count_modules(plan));
    assert_int_equal(done->made.textures, plan->n_normal_maps + plan->n_environments);
    assert_int_equal(done->made.draws, 6 * plan->n_environments);
    size_t draws = 0;
    for (size_t i = 0; i < scene->n_objects; i++)
        draws += 1 + (rl_plan_of_object(plan, scene, i)->highlight_program >= 0);
    assert_int_equal(done->frame.draws, draws);
    assert_int_equal(done->frame.textures + done->frame.programs + done->frame.modules, 0);
    assert_int_equal(done->frame.bytes_uploaded, 0);
}

/* Whether an effect other than `without` brings the module. */
static bool others_need(const char *module, size_t without)
{
    for (size_t row = 0; row < rl_n_effects; row++) {
        struct rl_plan_program program = {0};
        struct rl_material material = {0};
        if (row == without)
            continue;
        give(&material, rl_effects[row]);
        complete(&material, rl_effects[row]);
        rl_plan_add_effect(&program, rl_effects[row], rl_effect_given(&material, rl_effects[row]));
        for (size_t k = 0; k < program.n_modules; k++)
            if (strcmp(program.module[k], module) == 0)
                return true;
    }
    return false;
}

/* Bytes of the buffers that hold lights, by who sees them: points, a source, a polygon of four. */
static size_t light_bytes(unsigned sees)
{
    return (sees & RL_SEES_CENTROIDS ? 48 : 0) + (sees & RL_SEES_SOURCES ? 32 : 0) +
           (sees & RL_SEES_POLYGONS ? 32 + 4 * 16 : 0);
}

static void test_each_effect_removed(void **state)
{
    (void)state;
    struct rl_scene scene;
    struct done full;
    begin_scene(&scene, rl_n_effects);
    render_anew(&full, &scene);
    check_plan(&full, &scene);
    fixture_end(&scene);
    for (size_t row = 0; row < rl_n_effects; row++) {
        struct done less;
        begin_scene(&scene, row);
        render_anew(&less, &scene);
        check_plan(&less, &scene);
        /* Its modules are gone, and so is nothing that another needs. */
        struct rl_plan_program own = {0};
        struct rl_material material = {0};
        give(&material, rl_effects[row]);
        complete(&material, rl_effects[row]);
        rl_plan_add_effect(&own, rl_effects[row], rl_effect_given(&material, rl_effects[row]));
        for (size_t k = 0; k < own.n_modules; k++) {
            assert_true(has_module(&full.plan, own.module[k]));
            assert_int_equal(has_module(&less.plan, own.module[k]), others_need(own.module[k], row));
        }
        for (size_t i = 0; i < full.plan.n_programs; i++)
            for (size_t k = 0; k < full.plan.program[i].n_modules; k++) {
                const char *module = full.plan.program[i].module[k];
                bool mine = false;
                for (size_t j = 0; j < own.n_modules; j++)
                    mine = mine || strcmp(own.module[j], module) == 0;
                bool lights =
                    strcmp(module, "common/polygons") == 0; /* of all lights' only diffuse-area sees these */
                if (!mine && !(lights && rl_effects[row]->sees & RL_SEES_POLYGONS))
                    assert_true(has_module(&less.plan, module));
            }
        assert_false(has_module(&less.plan, own.module[own.n_modules - 1]));
        /* Textures, draws and meshes stay; a ball without effects shares the program of the highlight's, which has none either. */
        assert_int_equal(less.made.textures, full.made.textures);
        assert_int_equal(less.frame.draws, full.frame.draws);
        assert_int_equal(less.made.programs, full.made.programs - 1);
        assert_int_equal(full.made.bytes_uploaded - less.made.bytes_uploaded,
                         light_bytes(full.plan.sees) - light_bytes(less.plan.sees));
        clear(&less);
        fixture_end(&scene);
    }
    clear(&full);
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
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_each_effect_removed),
                                       cmocka_unit_test(test_kept), cmocka_unit_test(test_kept_among_others)};
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
