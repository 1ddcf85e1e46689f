/* Effects: the table and its descriptors, values in a material, the sums over lights; ambient and diffuse light by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "effects/effect.h"
#include "support/check.h"

/* One effect alone under some lights. */
static void shade(const char *name, const struct rl_material *material, const struct rl_surface *s,
                  const struct rl_lights *lights, double rgb[3])
{
    const struct rl_effect *effect = rl_effect_find(name);
    double params[1][RL_EFFECT_PARAMS][4];
    rgb[0] = rgb[1] = rgb[2] = NAN;
    effect->pack(rl_effect_given(material, effect), params[0]);
    rl_effects_shade(&effect, 1, params, s, lights, rgb);
}

static void check_rgb(const double rgb[3], double r, double g, double b)
{
    check_near(rgb[0], r, 1e-15 * (1.0 + fabs(r)));
    check_near(rgb[1], g, 1e-15 * (1.0 + fabs(g)));
    check_near(rgb[2], b, 1e-15 * (1.0 + fabs(b)));
}

static const struct rl_surface surface = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.6, 0.8}};

static void check_param(const struct rl_effect_param *p)
{
    assert_true(strlen(p->help) > 3 && !strchr(p->help, '\n'));
    if (p->kind == RL_EFFECT_CHOICE) {
        assert_non_null(p->choice[0].name);
        assert_true(p->absent[0] == 0.0 && !p->coefficient);
        return;
    }
    assert_true(p->low < p->high);
    for (int c = 0; c < (p->kind == RL_EFFECT_COLOUR ? 3 : 1) && !isnan(p->absent[c]) && !p->required; c++)
        assert_true(p->absent[c] >= p->low && p->absent[c] <= p->high);
}

static void test_descriptors(void **state)
{
    (void)state;
    assert_in_range(rl_n_effects, 1, RL_MATERIAL_EFFECTS_MAX);
    for (size_t i = 0; i < rl_n_effects; i++) {
        const struct rl_effect *e = rl_effects[i];
        struct rl_material material = {0};
        size_t n = 0;
        bool coefficient = false;
        assert_ptr_equal(rl_effect_find(e->name), e); /* no name comes twice */
        assert_true(strlen(e->summary) > 10 && !strchr(e->summary, '\n'));
        assert_in_range(e->n_params, 1, RL_EFFECT_PARAMS);
        assert_true(e->constant || e->reflect || e->area || e->factor);
        assert_true(!e->factor || !(e->constant || e->reflect || e->area));
        assert_true(!e->constant || !(e->reflect || e->area));
        assert_int_equal(rl_effect_gives(e), e->constant ? RL_GIVES_CONSTANT
                                             : e->factor ? RL_GIVES_FACTOR
                                                         : RL_GIVES_REFLECTED);
        assert_true((e->sees != 0) == (rl_effect_gives(e) == RL_GIVES_REFLECTED));
        assert_int_equal(!e->sees, !e->reflect && !e->area);
        assert_true(e->absolute >= 0.0 && e->relative >= 0.0 && e->absolute + e->relative > 0.0);
        for (; e->param[n].help; n++) {
            check_param(&e->param[n]);
            assert_true(e->param[n].key || n == 0);
            coefficient = coefficient || e->param[n].coefficient;
        }
        assert_in_range(n, 1, RL_EFFECT_KEYS_MAX);
        assert_true(coefficient);
        assert_in_range(rl_effect_values(e), 1, RL_EFFECT_VALUES_MAX);
        /* Not named, not wanted; named with every coefficient 0, not wanted either. */
        assert_false(rl_effect_wanted(&material, e));
        double *value = rl_effect_give(&material, e);
        for (size_t k = 0, v = 0; k < n; k++)
            for (int c = 0; c < (e->param[k].kind == RL_EFFECT_COLOUR ? 3 : 1); c++, v++)
                value[v] = e->param[k].coefficient ? 0.0 : value[v];
        assert_false(rl_effect_wanted(&material, e));
    }
    assert_null(rl_effect_find("nothing"));
}

/* Its coefficients 0, all else as large as it may be. Optional values, or only the one that `key` names. */
static void fill(double *value, const struct rl_effect *e, const char *key)
{
    for (size_t k = 0, v = 0; e->param[k].help; k++) {
        const struct rl_effect_param *p = &e->param[k];
        bool named = key && p->key && strcmp(p->key, key) == 0;
        for (int c = 0; c < (p->kind == RL_EFFECT_COLOUR ? 3 : 1); c++, v++)
            if (named || (!key && (p->required || !isnan(value[v])) && p->kind != RL_EFFECT_CHOICE))
                value[v] = p->coefficient ? 0.0 : p->high;
    }
}

/* What is dropped as not wanted would have been black, whatever its other values are, at a grazing angle. (A factor of 0 is not
 * dropped but drops the highlight.) */
static void test_unwanted_is_black(void **state)
{
    (void)state;
    const struct rl_surface grazing = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, -0.995, 0.0998749217771909}};
    const rl_vec3 L = {0.0, 0.995, 0.0998749217771909};
    const rl_vec3 triangle[3] = {{-1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, {0.0, 2.0, 1.0}};
    for (size_t i = 0; i < rl_n_effects; i++) {
        const struct rl_effect *e = rl_effects[i];
        struct rl_material material = {0};
        double params[RL_EFFECT_PARAMS][4], rgb[3] = {0.0};
        double *value = rl_effect_give(&material, e);
        const char *key = NULL;
        fill(value, e, NULL);
        if (e->check && e->check(value, &key))
            fill(value, e, key);
        assert_true(!e->check || !e->check(value, &key));
        assert_false(rl_effect_wanted(&material, e));
        e->pack(value, params);
        if (e->constant)
            e->constant(params, rgb);
        check_rgb(rgb, 0.0, 0.0, 0.0);
        if (e->reflect)
            e->reflect(&grazing, L, params, rgb);
        check_rgb(rgb, 0.0, 0.0, 0.0);
        if (e->area)
            e->area(&grazing, triangle, 3, params, rgb);
        check_rgb(rgb, 0.0, 0.0, 0.0);
    }
}

static void test_ambient(void **state)
{
    (void)state;
    struct rl_material material = {0};
    const struct rl_lights dark = {0};
    double rgb[3];
    rl_effect_give_colour(&material, "ambient", 0.0, 0.25, 1.5);
    assert_true(rl_effect_wanted(&material, rl_effect_find("ambient")));
    shade("ambient", &material, &surface, &dark, rgb);
    check_rgb(rgb, 0.0, 0.25, 1.5);
}

static void test_diffuse(void **state)
{
    (void)state;
    struct rl_material material = {0};
    const double pi = 3.14159265358979323846;
    double rgb[3];
    rl_effect_give_colour(&material, "diffuse", 1.0, 0.5, 0.0);
    assert_true(rl_effect_wanted(&material, rl_effect_find("diffuse")));

    /* Straight above at 2, facing down, area 1/2: radiance x 1/2 x 1 x 1/4. */
    struct rl_point_light light = {
        .position = {1.0, 0.0, 2.0}, .normal = {0.0, 0.0, -1.0}, .area = 0.5, .radiance = {8.0, 16.0, 32.0}};
    struct rl_lights lights = {.n_points = 1, .point = &light};
    shade("diffuse", &material, &surface, &lights, rgb);
    check_rgb(rgb, 1.0 / pi, 1.0 / pi, 0.0);
    /* It shines from both sides. */
    light.normal = v3(0.0, 0.0, 1.0);
    shade("diffuse", &material, &surface, &lights, rgb);
    check_rgb(rgb, 1.0 / pi, 1.0 / pi, 0.0);

    /* At (3, 0, 4) from P, r = 5: N.L = 4/5; the light's normal along x: cosine 3/5; 8 x 1/2 x 0.48/25. */
    light.position = v3(4.0, 0.0, 4.0);
    light.normal = v3(1.0, 0.0, 0.0);
    shade("diffuse", &material, &surface, &lights, rgb);
    check_rgb(rgb, 0.0768 / pi, 0.0768 / pi, 0.0);
    /* A light of many faces has no normal and no cosine of its own. */
    light.normal = v3(0.0, 0.0, 0.0);
    shade("diffuse", &material, &surface, &lights, rgb);
    check_rgb(rgb, 0.128 / pi, 0.128 / pi, 0.0);

    /* Two lights add up; one behind the surface, one in its plane and one at the point itself give nothing. */
    struct rl_point_light several[5] = {light, light, light, light, light};
    lights = (struct rl_lights){.n_points = 5, .point = several};
    several[2].position = v3(1.0, 0.0, -2.0);
    several[3].position = v3(7.0, 0.0, 0.0);
    several[4].position = surface.P;
    shade("diffuse", &material, &surface, &lights, rgb);
    check_rgb(rgb, 0.256 / pi, 0.256 / pi, 0.0);
}

/* k_d/pi I/r^2 cos(alpha) and k_d/pi E cos(alpha). */
static void test_sources(void **state)
{
    (void)state;
    struct rl_material material = {0};
    const double pi = 3.14159265358979323846;
    double rgb[3];
    rl_effect_give_colour(&material, "diffuse", 1.0, 0.5, 0.25);
    static const struct {
        struct rl_source source;
        double expected; /* of pi times the red value */
    } rows[] = {
        {{.at = {1.0, 0.0, 2.0}, .strength = {8.0, 8.0, 8.0}}, 2.0},    /* above, r = 2 */
        {{.at = {4.0, 0.0, 4.0}, .strength = {25.0, 25.0, 25.0}}, 0.8}, /* r = 5, cosine 4/5 */
        {{.at = {4.0, 0.0, 0.0}, .strength = {8.0, 8.0, 8.0}}, 0.0},    /* in the surface's plane */
        {{.at = {1.0, 0.0, -2.0}, .strength = {8.0, 8.0, 8.0}}, 0.0},   /* behind */
        {{.at = {1.0, 0.0, 0.0}, .strength = {8.0, 8.0, 8.0}}, 0.0},    /* at the point */
        {{.parallel = true, .at = {0.0, 0.0, 1.0}, .strength = {3.0, 3.0, 3.0}}, 3.0},
        {{.parallel = true, .at = {0.6, 0.0, 0.8}, .strength = {3.0, 3.0, 3.0}}, 2.4},
        {{.parallel = true, .at = {0.6, 0.0, -0.8}, .strength = {3.0, 3.0, 3.0}}, 0.0},
    };
    struct rl_source all[sizeof rows / sizeof rows[0]];
    double sum = 0.0;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        const struct rl_lights one = {.n_sources = 1, .source = &rows[i].source};
        shade("diffuse", &material, &surface, &one, rgb);
        check_rgb(rgb, rows[i].expected / pi, 0.5 * rows[i].expected / pi, 0.25 * rows[i].expected / pi);
        all[i] = rows[i].source;
        sum += rows[i].expected;
    }
    const struct rl_lights lights = {.n_sources = sizeof all / sizeof all[0], .source = all};
    shade("diffuse", &material, &surface, &lights, rgb);
    check_near(rgb[0], sum / pi, 1e-14);
}

/* What `below` promises where it is not set: nothing of light at or below the horizon, nothing of a polygon there. And `negative`, where that
 * is not set: nothing below 0. */
static void test_below(void **state)
{
    (void)state;
    for (size_t i = 0; i < rl_n_effects; i++) {
        const struct rl_effect *e = rl_effects[i];
        struct rl_material material = {0};
        double params[RL_EFFECT_PARAMS][4], rgb[3], most = 0.0, least = 0.0;
        double *value = rl_effect_give(&material, e);
        for (size_t k = 0; k < rl_effect_values(e); k++)
            value[k] = isnan(value[k]) ? NAN : 0.5;
        for (size_t k = 0; e->param[k].help; k++)
            if (e->param[k].kind == RL_EFFECT_CHOICE)
                value[rl_effect_value_of(e, k)] = 0.0;
            else if (e->param[k].coefficient || e->param[k].required)
                value[rl_effect_value_of(e, k)] = fmax(0.5, e->param[k].low);
        if (strncmp(e->name, "goldman", 7) == 0)
            value[7] = 0.5;
        e->pack(value, params);
        for (int k = 0; k < 1000 && e->reflect; k++) {
            double azimuth = 0.37 * k, height = -(k % 11) / 10.0, r = sqrt(1.0 - height * height);
            const struct rl_surface s = {.N = {0.0, 0.0, 1.0}, .V = {sin(0.011 * k), 0.0, cos(0.011 * k)}};
            e->reflect(&s, v3(r * cos(azimuth), r * sin(azimuth), height), params, rgb);
            most = fmax(most, fabs(rgb[0]));
            least = fmin(least, rgb[0]);
        }
        assert_true(e->negative == (least < 0.0));
        const rl_vec3 triangle[3] = {{1.0, 0.0, -1.0}, {-1.0, 1.0, -0.1}, {-1.0, -1.0, 0.0}};
        if (e->area) {
            e->area(&surface, triangle, 3, params, rgb);
            most = fmax(most, fabs(rgb[0]));
        }
        assert_true(e->below ? most > 0.01 : most == 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_descriptors), cmocka_unit_test(test_unwanted_is_black),
        cmocka_unit_test(test_ambient),     cmocka_unit_test(test_diffuse),
        cmocka_unit_test(test_sources),     cmocka_unit_test(test_below),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
