/* Effects: the table, ambient and diffuse light by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "effects/effect.h"
#include "support/check.h"

static const struct rl_effect *find(const char *name)
{
    for (size_t i = 0; i < rl_n_effects; i++)
        if (strcmp(rl_effects[i]->name, name) == 0)
            return rl_effects[i];
    fail_msg("no effect %s", name);
    return NULL;
}

static void shade(const struct rl_effect *effect, const struct rl_material *material,
                  const struct rl_surface *s, const struct rl_point_light *lights, size_t n, double rgb[3])
{
    double params[RL_EFFECT_PARAMS][4];
    rgb[0] = rgb[1] = rgb[2] = NAN;
    effect->pack(material, params);
    effect->shade(s, lights, n, params, rgb);
}

static void check_rgb(const double rgb[3], double r, double g, double b)
{
    check_near(rgb[0], r, 1e-15 * (1.0 + fabs(r)));
    check_near(rgb[1], g, 1e-15 * (1.0 + fabs(g)));
    check_near(rgb[2], b, 1e-15 * (1.0 + fabs(b)));
}

static const struct rl_surface surface = {{1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {0.0, 0.6, 0.8}};

static void test_descriptors(void **state)
{
    (void)state;
    const struct rl_material dark = {0};
    for (size_t i = 0; i < rl_n_effects; i++) {
        const struct rl_effect *e = rl_effects[i];
        assert_ptr_equal(find(e->name), e); /* no name comes twice */
        assert_true(strlen(e->summary) > 10 && !strchr(e->summary, '\n'));
        assert_in_range(e->n_params, 0, RL_EFFECT_PARAMS);
        assert_false(e->wanted(&dark));
        double rgb[3];
        shade(e, &dark, &surface, NULL, 0, rgb);
        check_rgb(rgb, 0.0, 0.0, 0.0);
    }
}

static void test_ambient(void **state)
{
    (void)state;
    const struct rl_effect *ambient = find("ambient");
    const struct rl_material material = {.ambient = {0.0, 0.25, 1.5}};
    double rgb[3];
    assert_true(ambient->wanted(&material));
    assert_false(ambient->needs_lights);
    shade(ambient, &material, &surface, NULL, 0, rgb);
    check_rgb(rgb, 0.0, 0.25, 1.5);
}

static void test_diffuse(void **state)
{
    (void)state;
    const struct rl_effect *diffuse = find("diffuse");
    const struct rl_material material = {.diffuse = {1.0, 0.5, 0.0}};
    const double pi = 3.14159265358979323846;
    double rgb[3];
    assert_true(diffuse->wanted(&material));
    assert_true(diffuse->needs_lights);

    /* Straight above at 2, facing down, area 1/2: radiance x 1/2 x 1 x 1/4. */
    struct rl_point_light light = {
        .position = {1.0, 0.0, 2.0}, .normal = {0.0, 0.0, -1.0}, .area = 0.5, .radiance = {8.0, 16.0, 32.0}};
    shade(diffuse, &material, &surface, &light, 1, rgb);
    check_rgb(rgb, 1.0 / pi, 1.0 / pi, 0.0);
    /* It shines from both sides. */
    light.normal = v3(0.0, 0.0, 1.0);
    shade(diffuse, &material, &surface, &light, 1, rgb);
    check_rgb(rgb, 1.0 / pi, 1.0 / pi, 0.0);

    /* At (3, 0, 4) from P, r = 5: N.L = 4/5; the light's normal along x: cosine 3/5; 8 x 1/2 x 0.48/25. */
    light.position = v3(4.0, 0.0, 4.0);
    light.normal = v3(1.0, 0.0, 0.0);
    shade(diffuse, &material, &surface, &light, 1, rgb);
    check_rgb(rgb, 0.0768 / pi, 0.0768 / pi, 0.0);
    /* A light of many faces has no normal and no cosine of its own. */
    light.normal = v3(0.0, 0.0, 0.0);
    shade(diffuse, &material, &surface, &light, 1, rgb);
    check_rgb(rgb, 0.128 / pi, 0.128 / pi, 0.0);

    /* Two lights add up; one behind the surface, one in its plane and one at the point itself give nothing. */
    struct rl_point_light several[5] = {light, light, light, light, light};
    several[2].position = v3(1.0, 0.0, -2.0);
    several[3].position = v3(7.0, 0.0, 0.0);
    several[4].position = surface.P;
    shade(diffuse, &material, &surface, several, 5, rgb);
    check_rgb(rgb, 0.256 / pi, 0.256 / pi, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_descriptors),
        cmocka_unit_test(test_ambient),
        cmocka_unit_test(test_diffuse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
