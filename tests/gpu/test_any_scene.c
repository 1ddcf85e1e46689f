/* What the plan drops changes no pixel by a bit, whatever is in a scene: random ones with lights above and below, objects in view and not, effects
 * that do something and that do nothing. */
#include "gpu/fixture.h"
#include "model/random.h"
#include "studies/features.h"

static const uint64_t seed = 20261125;

static struct rl_gpu *gpu;
static uint64_t next;

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

static double uniform(double low, double high)
{
    return low + (high - low) * rl_random_uniform(seed, next++);
}

static size_t below(size_t n)
{
    return (size_t)(uniform(0.0, 1.0) * (double)n);
}

static rl_vec3 somewhere(double reach)
{
    double x = uniform(-reach, reach), y = uniform(-reach, reach);
    return v3(x, y, uniform(-reach, reach));
}

/* Effects of the table that go together, some with coefficients of 0, and a highlight or none. */
static void fill_material(struct rl_material *m, const struct rl_feature *feature, size_t n)
{
    unsigned taken = 0;
    for (int k = 0; k < 4; k++) {
        const struct rl_feature *f = &feature[below(n)];
        unsigned roles = f->kind == RL_FEATURE_EFFECT ? f->effect->roles : RL_ROLE_HIGHLIGHT;
        if (f->kind == RL_FEATURE_SWITCH || taken & roles)
            continue;
        taken |= roles;
        if (f->kind == RL_FEATURE_HIGHLIGHT) {
            m->method = f->name;
            continue;
        }
        rl_feature_give(m, f->effect);
        double *value = m->effect[rl_effect_row(f->effect)].value;
        bool nothing = uniform(0.0, 1.0) < 0.3;
        for (size_t i = 0, at = 0; nothing && f->effect->param[i].help; i++)
            for (int c = 0; c < (f->effect->param[i].kind == RL_EFFECT_COLOUR ? 3 : 1); c++, at++)
                if (f->effect->param[i].coefficient && !isnan(value[at]) && f->effect->param[i].low == 0.0)
                    value[at] = 0.0;
    }
    m->rr = uniform(1.0, 30.0);
    for (int c = 0; c < 3; c++)
        m->specular[c] = uniform(0.0, 1.0) < 0.1 ? 0.0 : 1.0;
}

static void any_scene(struct rl_scene *scene, const struct rl_feature *feature, size_t n)
{
    static char *const name = "any";
    static const enum rl_shape shapes[] = {RL_SHAPE_SPHERE, RL_SHAPE_PLANE, RL_SHAPE_TORUS, RL_SHAPE_DISC};
    fixture_begin(scene, 48, 36);
    fixture_camera(scene, v3_add(v3(0.0, 1.0, 6.0), somewhere(1.0)), somewhere(1.0), uniform(20.0, 60.0));
    for (int i = 0; i < 4; i++) {
        fixture_material(scene, 1.0, 0.0, 0.0, 1.0, NULL);
        memset(scene->material[i].effect, 0, sizeof scene->material[i].effect);
        scene->material[i].name = name;
        fill_material(&scene->material[i], feature, n);
    }
    for (size_t i = 0; i < 2 + below(4); i++) {
        fixture_object(scene, shapes[below(4)], 3, uniform(0.3, 1.5), somewhere(3.0), (int)below(4));
        scene->object[i].name = name;
    }
    for (size_t i = 0; i < below(4); i++) {
        double radiance = uniform(0.0, 1.0) < 0.25 ? 0.0 : uniform(0.5, 3.0);
        fixture_quad(scene, somewhere(5.0), v3(uniform(0.2, 1.0), 0.0, 0.0), v3(0.0, uniform(0.2, 1.0), 0.0),
                     radiance, radiance, 0.5 * radiance);
        scene->light[i].name = name;
    }
    for (size_t i = 0; i < below(5); i++) {
        double strength = uniform(0.0, 1.0) < 0.2 ? 0.0 : uniform(0.5, 3.0);
        fixture_source(scene, uniform(0.0, 1.0) < 0.5, somewhere(4.0), strength, strength, 0.5 * strength);
        scene->source[i].name = name;
    }
}

static void test_any_scene(void **state)
{
    (void)state;
    struct rl_feature feature[RL_FEATURES_MAX];
    size_t n = rl_features_list(feature), drops = 0;
    for (int k = 0; k < 16; k++) {
        struct rl_error error;
        struct rl_scene scene;
        struct rl_plan plan;
        struct rl_settings settings = RL_SETTINGS_DEFAULT;
        next = (uint64_t)k << 32;
        any_scene(&scene, feature, n);
        settings.env_size = 32;
        settings.normal_size = 64;
        settings.attenuation = uniform(0.0, 1.0) < 0.7;
        settings.margin_kind = uniform(0.0, 1.0) < 0.3 ? RL_MARGIN_VALUE : RL_MARGIN_OFF;
        settings.margin = 0.3;
        settings.culling = uniform(0.0, 1.0) < 0.7;
        settings.interpolation = (int)below(RL_INTERPOLATIONS);
        check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
        drops += plan.n_drops;
        rl_plan_clear(&plan);
        fixture_check_drop(gpu, &scene, settings);
        fixture_end(&scene);
    }
    print_message("seed %llu, %zu drops\n", (unsigned long long)seed, drops);
    assert_true(drops > 50);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_any_scene)};
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
