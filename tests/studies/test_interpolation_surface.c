/* The study `interpolation`: points of the exact surface are found on every mesh. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "model/random.h"
#include "scene/shapes.h"
#include "studies/interpolation.h"
#include "support/check.h"

static const char *const objects[] = {"sphere", "teapot"};

static rl_vec3 mean_position(const struct rl_mesh *mesh, const struct rl_mesh_point *at)
{
    rl_vec3 sum = v3(0.0, 0.0, 0.0);
    for (int k = 0; k < 3; k++) {
        const float *p = mesh->position[mesh->triangle[at->triangle][k]];
        sum = v3_madd(sum, at->weight[k], v3(p[0], p[1], p[2]));
    }
    return sum;
}

/* Any point of any mesh goes to the exact surface and comes back; a coarser mesh has it too, nearby. */
static void points_are_found(void **state)
{
    (void)state;
    static const int tessellation[] = {1, 2, 3, 8, 17};
    for (int o = 0; o < 2; o++)
        for (size_t i = 0; i < sizeof tessellation / sizeof tessellation[0]; i++) {
            struct rl_error error;
            struct rl_mesh mesh;
            struct rl_mesh_locator *locator;
            int n = tessellation[i];
            check_ok(rl_shape_build(&mesh, o ? RL_SHAPE_TEAPOT : RL_SHAPE_SPHERE, n, 0.0, &error), &error);
            check_ok(rl_mesh_locator_make(&locator, objects[o], &mesh, n, &error), &error);
            for (uint64_t k = 0; k < 3000; k++) {
                double a = rl_random_uniform(7, 3 * k), b = rl_random_uniform(7, 3 * k + 1) * (1.0 - a);
                size_t triangle = (size_t)(rl_random_uniform(7, 3 * k + 2) * (double)mesh.n_triangles);
                struct rl_mesh_point from = {triangle, {1.0 - a - b, a, b}}, back;
                struct rl_exact_point p, again;
                rl_exact_from_mesh(&p, objects[o], &mesh, n, &from);
                check_near(v3_length(p.N), 1.0, 1e-12);
                back = rl_mesh_locate(locator, &p);
                check_near(back.weight[0] + back.weight[1] + back.weight[2], 1.0, 1e-12);
                for (int c = 0; c < 3; c++)
                    assert_true(back.weight[c] > -1e-6);
                check_near(v3_length(v3_sub(mean_position(&mesh, &from), mean_position(&mesh, &back))), 0.0,
                           1e-6);
                rl_exact_from_mesh(&again, objects[o], &mesh, n, &back);
                check_near(v3_length(v3_sub(p.P, again.P)), 0.0, 1e-6);
            }
            rl_mesh_locator_free(locator);
            rl_mesh_clear(&mesh);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
