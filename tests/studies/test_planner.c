/* Shares of a plan: which group is in which; scenes by name and by path. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "studies/planner.h"

/* The share that a group is in: pinned, since machines have to agree; and untouched by order, numbering and environment. */
static void test_share_of_a_group(void **state)
{
    (void)state;
    static const struct {
        int n_shards, expected[3]; /* of the groups 0, 1, 2 */
    } row[] = {{1, {1, 1, 1}}, {2, {1, 2, 2}}, {3, {1, 2, 3}}, {7, {2, 1, 5}}, {1000, {829, 578, 752}}};
    static const struct rl_place place = {"made-up", "ball", "ball.yaml", 7};
    struct rl_run forth = {0}, back = {0};
    for (int i = 0; i < 6; i++) {
        assert_non_null(rl_run_add(&forth, &place, i / 2, NULL, "number=%d arm=%d", i / 2, i % 2));
        assert_non_null(rl_run_add(&back, &place, 9 + i / 2, NULL, "number=%d arm=%d", 2 - i / 2, 1 - i % 2));
    }
    rl_run_identify(&forth, "here");
    rl_run_identify(&back, "elsewhere");
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
        for (size_t g = 0; g < 3; g++)
            for (int shard = 1; shard <= row[i].n_shards; shard++) {
                struct rl_run_options options = {.shard = shard, .n_shards = row[i].n_shards};
                bool wanted = rl_group_wanted(&forth, 2 * g, &options);
                assert_int_equal(wanted, rl_group_wanted(&back, 2 * (2 - g), &options));
                assert_int_equal(wanted, shard == row[i].expected[g]);
            }
    rl_run_clear(&forth);
    rl_run_clear(&back);
}

static void test_scenes(void **state)
{
    (void)state;
    struct rl_scene scene = {0};
    struct rl_error error = {0};
    assert_int_equal(rl_study_scene_load(&scene, "teapot-star", &error), RL_OK);
    rl_scene_clear(&scene);
    assert_int_equal(rl_study_scene_load(&scene, "studies/scenes/sphere-quad.yaml", &error), RL_OK);
    rl_scene_clear(&scene);
    assert_int_equal(rl_study_scene_load(&scene, "no-such-scene", &error), RL_ERR_INPUT);
    assert_non_null(strstr(error.message, "no-such-scene"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_share_of_a_group),
                                       cmocka_unit_test(test_scenes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
