/* A scene less one feature is just that feature's share less: for every effect of the table, every highlight method that runs on the GPU,
 * attenuation, bounding spheres and culling. What a plan is to make and to draw is written down as an inventory, what was made and drawn is what the
 * GL layer counted; both agree, and between two scenes' inventories lies what the feature alone had needed and nothing else needs. */
#include "gpu/fixture.h"
#include "gpu/inventory.h"

static struct rl_gpu *gpu;
static struct rl_feature feature[RL_FEATURES_MAX];
static size_t n_features;

static int open_gpu(void **state)
{
    (void)state;
    struct rl_error error;
    n_features = rl_features_list(feature);
    return rl_gpu_open(&gpu, "auto", &error);
}

static int close_gpu(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    return 0;
}

/* ---- Comparing ---- */

static void check_all_in(const char *name, const struct inventory *some, const struct inventory *all)
{
    for (size_t i = 0; i < some->n; i++)
        if (!inventory_has(all, some->item[i].name))
            fail_msg("%s: '%s' has come instead", name, some->item[i].name);
}

/* Whether a program has the module, or it is in the list itself. */
static bool mentions(const struct inventory *list, const char *module)
{
    size_t length = strlen(module);
    for (size_t i = 0; i < list->n; i++)
        for (const char *at = list->item[i].name; (at = strstr(at, module)); at += length)
            if ((at == list->item[i].name || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
                return true;
    return false;
}

/* full less `without` is `alone` less `without`: what the feature needed by itself and no other does. Something is. */
static void check_share(const char *name, const char *own_module, const struct inventory *full,
                        const struct inventory *without, const struct inventory *alone)
{
    size_t n = 0;
    check_all_in(name, without, full);
    for (size_t i = 0; i < full->n; i++) {
        const char *item = full->item[i].name;
        if (inventory_has(without, item))
            continue;
        n++;
        if (!inventory_has(alone, item))
            fail_msg("%s: '%s' is gone with it, and was not its own", name, item);
    }
    for (size_t i = 0; i < alone->n; i++)
        if (!inventory_has(full, alone->item[i].name))
            fail_msg("%s: alone it needs '%s', which the full scene does not have", name,
                     alone->item[i].name);
    assert_true(mentions(full, own_module));
    assert_false(mentions(without, own_module));
    if (n == 0)
        fail_msg("%s: nothing is gone with it", name);
}

/* The distinct modules in the place of the programs: where a material has several effects its program is another without one. */
static void only_modules(struct inventory *list)
{
    struct inventory *modules = malloc(sizeof *modules);
    assert_non_null(modules);
    modules->n = 0;
    for (size_t i = 0; i < list->n; i++) {
        char *item = list->item[i].name, *rest = NULL;
        if (strncmp(item, "program:", 8) != 0) {
            modules->item[modules->n++] = list->item[i];
            continue;
        }
        for (char *m = strtok_r(item + 8, " ", &rest); m; m = strtok_r(NULL, " ", &rest))
            if (!inventory_has(modules, m))
                inventory_add(modules, "%s", m);
    }
    *list = *modules;
    free(modules);
}

/* ---- A ball for each feature ---- */

/* Ball i has feature i, and the last one nothing; a factor's has a highlight too, whether it has the factor or not. With `factors` off
 * these are bare, so that no method is in use but on its own ball. */
static void begin_balls(struct rl_scene *scene, bool factors)
{
    size_t n = n_features - RL_SWITCHES;
    static char *const name = "ball";
    fixture_begin(scene, 64, 48);
    free(scene->material);
    free(scene->object);
    scene->material = calloc(n + 1, sizeof *scene->material);
    scene->object = calloc(n + 1, sizeof *scene->object);
    assert_true(scene->material && scene->object);
    fixture_camera(scene, v3(0.0, 0.0, 14.0), v3(0.0, 0.0, 0.0), 70.0);
    for (size_t i = 0; i <= n; i++) {
        struct rl_material *m = &scene->material[scene->n_materials++];
        bool factor = i < n && rl_feature_needs_highlight(&feature[i]);
        m->name = name;
        m->rr = 10.0 + (double)i;
        m->specular[0] = m->specular[1] = m->specular[2] = 1.0;
        if (i < n && feature[i].kind == RL_FEATURE_HIGHLIGHT)
            m->method = feature[i].method->name;
        else if (factor && factors)
            m->method = "random";
        if (i < n && feature[i].kind == RL_FEATURE_EFFECT && (!factor || factors))
            rl_feature_give(m, feature[i].effect);
        fixture_object(scene, RL_SHAPE_SPHERE, 4, 0.4, v3((double)i - 0.5 * (double)n, 0.0, 0.0), (int)i);
        scene->object[i].name = name;
    }
    fixture_quad(scene, v3(-2.0, 2.0, 6.0), v3(0.8, 0.8, 0.0), v3(0.5, -0.5, 0.5), 2.0, 1.5, 1.0);
    fixture_source(scene, false, v3(1.0, 2.0, 6.0), 1.0, 1.0, 0.5);
    fixture_source(scene, true, v3(0.2, 0.5, 1.0), 1.0, 1.0, 0.5);
}

static struct rl_settings small(void)
{
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    settings.env_size = 16;
    settings.normal_size = 64;
    settings.width = 64;
    settings.height = 48;
    return settings;
}

/* Adds the modules that a feature brings by its descriptor: its own, and those of the lights that it sees and of the tables it asks for. */
static void list_modules(struct rl_plan_program *own, const struct rl_feature *f)
{
    if (f->kind == RL_FEATURE_EFFECT) {
        struct rl_material material = {0};
        rl_feature_give(&material, f->effect);
        rl_plan_add_effect(own, f->effect, rl_effect_given(&material, f->effect));
    }
    const unsigned sees = f->effect ? f->effect->sees : 0;
    const struct rl_method none = {0}, *m = f->method ? f->method : &none;
    const struct {
        bool needed;
        const char *module;
    } rows[] = {
        {sees & RL_SEES_SOURCES, "common/sources"},
        {sees & RL_SEES_SOURCES, "common/point_sources"},
        {sees & RL_SEES_SOURCES, "common/parallel_sources"},
        {sees & RL_SEES_CENTROIDS, "common/centroids"},
        {sees & RL_SEES_POLYGONS, "common/polygons"},
        {sees & RL_SEES_CENTROIDS || m->needs_point_lights, "common/lights"},
        {m->needs_environment, "common/environment"},
        {m->needs_normal_map, "common/normal_map"},
        {m->needs_pattern, "common/pattern"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (rows[i].needed)
            rl_plan_add_module(own, rows[i].module);
}

/* Alone, a feature links no module that only others bring. */
static void check_own(const struct inventory *alone, const struct rl_feature *f)
{
    struct rl_plan_program own = {.pass = ""};
    list_modules(&own, f);
    for (size_t j = 0; j < own.n_modules; j++)
        assert_true(mentions(alone, own.module[j]));
    /* A factor comes with highlights. */
    for (size_t i = 0; i < n_features - RL_SWITCHES && rl_feature_needs_highlight(f); i++)
        if (feature[i].kind == RL_FEATURE_HIGHLIGHT)
            list_modules(&own, &feature[i]);
    for (size_t i = 0; i < n_features - RL_SWITCHES; i++) {
        struct rl_plan_program others = {.pass = ""};
        list_modules(&others, &feature[i]);
        for (size_t k = 0; k < others.n_modules; k++) {
            bool mine = false;
            for (size_t j = 0; j < own.n_modules; j++)
                mine = mine || strcmp(own.module[j], others.module[k]) == 0;
            if (!mine && mentions(alone, others.module[k]))
                fail_msg("%s: alone it links %s, which is %s's", f->name, others.module[k], feature[i].name);
        }
    }
}

/* The view with that feature alone: without the others, but for the highlights that a factor acts on, and the factors on a highlight. */
static void leave(struct rl_view *view, const struct rl_feature *f)
{
    for (size_t k = 0; k < n_features - RL_SWITCHES; k++) {
        const struct rl_feature *other = &feature[k];
        bool together = other->kind == RL_FEATURE_HIGHLIGHT
                            ? f->kind == RL_FEATURE_EFFECT && rl_feature_needs_highlight(f)
                            : f->kind == RL_FEATURE_HIGHLIGHT && rl_feature_needs_highlight(other);
        if (strcmp(other->name, f->name) != 0 && !together)
            rl_view_remove(view, other);
    }
}

/* With `modules`, programs are looked at by their modules. */
static struct inventory *take_of(const char *what, const struct rl_view *view, bool modules)
{
    struct inventory *list = inventory_take(what, gpu, view);
    if (modules)
        only_modules(list);
    return list;
}

static void compare(const struct inventory *all, const struct rl_view *full, const struct rl_feature *f,
                    bool modules)
{
    struct rl_error error;
    struct rl_view without, alone;
    char module[64], identifier[32];
    check_ok(rl_view_copy(&without, full, &error), &error);
    check_ok(rl_view_copy(&alone, full, &error), &error);
    rl_view_remove(&without, f);
    leave(&alone, f);
    struct inventory *less = take_of(f->name, &without, modules), *own = take_of("alone", &alone, modules);
    if (f->effect)
        rl_effect_identifier(identifier, f->effect);
    snprintf(module, sizeof module, "%s/%s", f->effect ? "effects" : "methods",
             f->effect ? identifier : f->name);
    check_share(f->name, module, all, less, own);
    if (!modules)
        check_own(own, f);
    free(less);
    free(own);
    rl_view_clear(&without);
    rl_view_clear(&alone);
}

/* Where every ball has one feature, whole programs come and go. */
static void test_one_each(void **state)
{
    (void)state;
    struct rl_error error;
    const struct rl_settings settings = small();
    for (int kind = RL_FEATURE_EFFECT; kind <= RL_FEATURE_HIGHLIGHT; kind++) {
        struct rl_scene scene;
        struct rl_view full;
        begin_balls(&scene, kind == RL_FEATURE_EFFECT);
        check_ok(rl_view_make(&full, &scene, &settings, &error), &error);
        struct inventory *all = take_of("full", &full, false);
        for (size_t i = 0; i < n_features; i++)
            if ((int)feature[i].kind == kind)
                compare(all, &full, &feature[i], false);
        free(all);
        rl_view_clear(&full);
        fixture_end(&scene);
    }
}

/* The same of a scene as one would write it, where materials have several; a feature that it does not name is hosted. */
static void test_everything(void **state)
{
    (void)state;
    struct rl_error error;
    struct rl_scene scene;
    struct rl_view full;
    const struct rl_settings settings = small();
    check_ok(rl_scene_load(&scene, "studies/scenes/everything.yaml", &error), &error);
    check_ok(rl_view_make(&full, &scene, &settings, &error), &error);
    struct inventory *all = take_of("full", &full, true);
    for (size_t i = 0; i < n_features - RL_SWITCHES; i++) {
        if (rl_feature_named(&scene, &feature[i])) {
            compare(all, &full, &feature[i], true);
            continue;
        }
        struct rl_view hosted;
        check_ok(rl_view_copy(&hosted, &full, &error), &error);
        rl_view_host(&hosted, &feature[i]);
        struct inventory *with = take_of("hosted", &hosted, true);
        compare(with, &hosted, &feature[i], true);
        free(with);
        rl_view_clear(&hosted);
    }
    free(all);
    rl_view_clear(&full);
    rl_scene_clear(&scene);
}

/* Attenuation is a module in the place of another; the spheres are a pass, with its program and buffer; culling is a state and, of
 * the point seen, a module in the place of another. */
static void test_switches(void **state)
{
    (void)state;
    static const struct {
        const char *gone, *come; /* part of each item's name */
        size_t least, most;      /* items gone */
    } expected[RL_SWITCHES] = {
        [RL_SWITCH_ATTENUATION] = {"common/attenuation", "common/attenuation_off", 1, 1},
        [RL_SWITCH_SPHERE] = {"sphere", "nothing", 3, 99},
        [RL_SWITCH_CULLING] = {"common/visible", "common/visible_both", 1, 1},
    };
    struct rl_error error;
    struct rl_scene scene;
    const struct rl_settings settings = small();
    begin_balls(&scene, true);
    for (size_t i = n_features - RL_SWITCHES; i < n_features; i++) {
        struct rl_view full, without;
        size_t n = 0;
        check_ok(rl_view_make(&full, &scene, &settings, &error), &error);
        check_ok(rl_view_copy(&without, &full, &error), &error);
        rl_view_remove(&without, &feature[i]);
        struct inventory *all = take_of("full", &full, true),
                         *less = take_of(feature[i].name, &without, true);
        for (size_t k = 0; k < all->n; k++)
            if (!inventory_has(less, all->item[k].name)) {
                n++;
                if (!strstr(all->item[k].name, expected[feature[i].which].gone))
                    fail_msg("%s: %s is gone", feature[i].name, all->item[k].name);
            }
        for (size_t k = 0; k < less->n; k++)
            if (!inventory_has(all, less->item[k].name))
                assert_string_equal(less->item[k].name, expected[feature[i].which].come);
        assert_in_range(n, expected[feature[i].which].least, expected[feature[i].which].most);
        free(all);
        free(less);
        rl_view_clear(&full);
        rl_view_clear(&without);
    }
    fixture_end(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_each),
        cmocka_unit_test(test_everything),
        cmocka_unit_test(test_switches),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
