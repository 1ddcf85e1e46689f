/* Cube maps of the CPU at their limits: directions on edges and corners of the cube and just off them, lights whose own edges run along these
 * or through the centres of texels. Every answer is exact, a count or a bit pattern. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "reference/cube_map.h"
#include "reference/fixture.h"
#include "support/check.h"

enum { SIZE = 8 };

/* At the limit, one unit in the last place of 1 either way, and farther. */
static const double off[] = {0.0, 0x1p-52, -0x1p-53, 1e-12, -1e-12, 1e-6, -1e-6, 1e-3, -1e-3};

static double largest(rl_vec3 v)
{
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/* How many faces have the direction: those along whose outward axis it is largest. */
static int faces_of(rl_vec3 d)
{
    int n = 0;
    for (int face = 0; face < RL_CUBE_FACES; face++)
        n += rl_cube_on_face(face, d).z == largest(d);
    return n;
}

/* (s, t) of a face and back, bit for bit, whatever is beyond its edges; on an edge two faces have the direction, in a corner three, and just
 * off them one: the face itself inside, its neighbour outside. */
static void test_edges_and_corners(void **state)
{
    (void)state;
    static const double along[] = {0.0, 0.3, -0.999, 1.0, -1.0};
    for (int face = 0; face < RL_CUBE_FACES; face++)
        for (int edge = 0; edge < 4; edge++)
            for (size_t a = 0; a < LENGTH(along); a++)
                for (size_t i = 0; i < LENGTH(off); i++) {
                    double at = (edge & 1 ? 1.0 : -1.0) * (1.0 + off[i]);
                    double s = edge & 2 ? at : along[a], t = edge & 2 ? along[a] : at;
                    rl_vec3 d = rl_cube_direction(face, s, t), back = rl_cube_on_face(face, d);
                    assert_true(back.x == s && back.y == t && back.z == 1.0);
                    bool corner = fabs(along[a]) == 1.0;
                    int expected = off[i] > 0.0 ? 1 : (off[i] == 0.0) + 1 + (corner && 1);
                    /* A corner's other edge still is one where this edge is left inwards. */
                    if (faces_of(d) != expected)
                        fail_msg("face %d at %.17g, %.17g: %d faces, expected %d", face, s, t, faces_of(d),
                                 expected);
                    assert_int_equal(back.z == largest(d), off[i] <= 0.0);
                }
}

static size_t count(const struct rl_cube_map *map, int face, int light)
{
    size_t n = 0;
    for (int i = 0; i < SIZE * SIZE; i++)
        n += map->seen[face * SIZE * SIZE + i] == light;
    return n;
}

/* A square that covers a face, to its edges and corners, a little more or a little less: it is in all of the face's texels, and in none
 * of the others', whose centres are 1/SIZE from there. */
static void test_a_face_covered(void **state)
{
    (void)state;
    for (int face = 0; face < RL_CUBE_FACES; face++)
        for (size_t i = 0; i < LENGTH(off); i++)
            for (int turn = -1; turn <= 1; turn += 2) {
                double e = 1.0 + off[i];
                struct shape square = {.n = 4};
                const double s[] = {-e, e, e, -e}, t[] = {-e, -e, e, e};
                for (int k = 0; k < 4; k++)
                    square.vertex[k] = v3_scale(2.5, rl_cube_direction(face, turn * s[k], t[k]));
                struct rl_light_set *set = set_of(&square, 1);
                struct rl_cube_map map;
                struct rl_error error;
                check_ok(rl_cube_map_make(&map, set, v3(0, 0, 0), SIZE, &error), &error);
                for (int other = 0; other < RL_CUBE_FACES; other++)
                    assert_int_equal(count(&map, other, 1), other == face ? SIZE * SIZE : 0);
                rl_cube_map_clear(&map);
                rl_light_set_free(set);
            }
}

/* Two lights that meet in a line through a face, along the centres of a column or row of texels and just off it, or along the cube's own
 * edge (s = 1): every texel sees one of them, so that none is lost between, and those to either side theirs. */
static void test_lights_that_meet(void **state)
{
    (void)state;
    static const double radiance[] = {1.0, 0.5}, line[] = {-0.875, 0.125, 0.375, 1.0};
    for (int face = 0; face < RL_CUBE_FACES; face++)
        for (size_t l = 0; l < LENGTH(line); l++)
            for (size_t i = 0; i < LENGTH(off); i++)
                for (int way = 0; way < 4; way++) {
                    bool rows = way & 1, reversed = way & 2; /* the shared edge is gone along either way */
                    double at = line[l] * (1.0 + off[i]);
                    struct shape half[2];
                    for (int k = 0; k < 2; k++) {
                        double far = k ? 1.5 : -1.5;
                        const double s[] = {at, far, far, at}, t[] = {-1.5, -1.5, 1.5, 1.5};
                        half[k].n = 4;
                        for (int v = 0; v < 4; v++)
                            half[k].vertex[reversed && k ? 3 - v : v] =
                                rl_cube_direction(face, rows ? t[v] : s[v], rows ? s[v] : t[v]);
                    }
                    struct rl_light_set *set = lights_of(half, radiance, 2);
                    struct rl_cube_map map;
                    struct rl_error error;
                    check_ok(rl_cube_map_make(&map, set, v3(0, 0, 0), SIZE, &error), &error);
                    assert_int_equal(count(&map, face, 0), 0);
                    for (int x = 0; x < SIZE; x++)
                        for (int y = 0; y < SIZE; y++) {
                            double centre = (2 * x + 1.0) / SIZE - 1.0;
                            int texel = rows ? x * SIZE + y : y * SIZE + x;
                            if (fabs(centre - at) > 1e-9) /* else either, by rounding */
                                assert_int_equal(map.seen[face * SIZE * SIZE + texel], centre < at ? 1 : 2);
                        }
                    rl_cube_map_clear(&map);
                    rl_light_set_free(set);
                }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_edges_and_corners),
        cmocka_unit_test(test_a_face_covered),
        cmocka_unit_test(test_lights_that_meet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
