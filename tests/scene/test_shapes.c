/* Built-in shapes: closed where they should be, facing outwards, with the exact normals of the surface. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "scene/shapes.h"
#include "support/check.h"

static struct rl_error error;

static rl_vec3 load(const float v[3])
{
    return v3(v[0], v[1], v[2]);
}

static int compare_edges(const void *a, const void *b)
{
    const uint64_t *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* Every edge occurs once in each direction: no hole, no flap, one orientation. */
static bool is_closed(const struct rl_mesh *mesh)
{
    size_t n = 3 * mesh->n_triangles;
    uint64_t *there = malloc(n * sizeof *there), *back = malloc(n * sizeof *back);
    assert_non_null(there);
    assert_non_null(back);
    for (size_t i = 0; i < n; i++) {
        uint64_t a = mesh->triangle[i / 3][i % 3], b = mesh->triangle[i / 3][(i + 1) % 3];
        there[i] = a << 32 | b;
        back[i] = b << 32 | a;
    }
    qsort(there, n, sizeof *there, compare_edges);
    qsort(back, n, sizeof *back, compare_edges);
    bool closed = true;
    for (size_t i = 0; i < n; i++)
        closed = closed && there[i] == back[i] && (i == 0 || there[i] != there[i - 1]);
    free(there);
    free(back);
    return closed;
}

struct measures {
    double area, volume;
    double least_facing; /* of any vertex normal with its triangle's: their cosine */
};

static struct measures measure(const struct rl_mesh *mesh)
{
    struct measures m = {.least_facing = 1.0};
    for (size_t t = 0; t < mesh->n_triangles; t++) {
        rl_vec3 p[3];
        for (int i = 0; i < 3; i++) {
            assert_true(mesh->triangle[t][i] < mesh->n_vertices);
            p[i] = load(mesh->position[mesh->triangle[t][i]]);
        }
        rl_vec3 cross = v3_cross(v3_sub(p[1], p[0]), v3_sub(p[2], p[0]));
        m.area += 0.5 * v3_length(cross);
        m.volume += v3_dot(p[0], v3_cross(p[1], p[2])) / 6.0;
        for (int i = 0; i < 3; i++)
            m.least_facing =
                fmin(m.least_facing, v3_dot(v3_normalize(cross), load(mesh->normal[mesh->triangle[t][i]])));
    }
    return m;
}

/* Areas and volumes of the smooth shapes; tessellation n comes within a few times (pi/4n)^2 of them, from
 * below. */
static void test_sizes(void **state)
{
    (void)state;
    static const struct {
        double minor, area, volume;
        enum rl_shape shape;
        bool closed;
    } cases[] = {
        {0.0, 4.0 * RL_PI, 4.0 / 3.0 * RL_PI, RL_SHAPE_SPHERE, true},
        {0.4, 4.0 * RL_PI * RL_PI * 0.4, 2.0 * RL_PI * RL_PI * 0.16, RL_SHAPE_TORUS, true},
        {0.0, 4.0, 0.0, RL_SHAPE_PLANE, false},
        {0.0, RL_PI, 0.0, RL_SHAPE_DISC, false},
    };
    static const int levels[] = {1, 2, 7, 40};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (size_t j = 0; j < sizeof levels / sizeof levels[0]; j++) {
            struct rl_mesh mesh;
            check_ok(rl_shape_build(&mesh, cases[i].shape, levels[j], cases[i].minor, &error), &error);
            struct measures m = measure(&mesh);
            double step = RL_PI / (4.0 * levels[j]);
            assert_true(m.area <= cases[i].area * (1.0 + 1e-6));
            assert_true(m.area >= cases[i].area * (1.0 - step * step));
            check_near(m.volume, cases[i].volume, 1e-6 + cases[i].volume * 2.0 * step * step);
            assert_int_equal(is_closed(&mesh), cases[i].closed);
            assert_true(m.least_facing > 0.5);
            rl_mesh_clear(&mesh);
        }
}

static void test_normals(void **state)
{
    (void)state;
    struct rl_mesh mesh;
    check_ok(rl_shape_build(&mesh, RL_SHAPE_SPHERE, 9, 0.0, &error), &error);
    for (size_t i = 0; i < mesh.n_vertices; i++)
        check_near(v3_length(v3_sub(load(mesh.position[i]), load(mesh.normal[i]))), 0.0, 1e-7);
    rl_mesh_clear(&mesh);

    /* A torus's normal points from the nearest point of its ring. */
    check_ok(rl_shape_build(&mesh, RL_SHAPE_TORUS, 9, 0.3, &error), &error);
    for (size_t i = 0; i < mesh.n_vertices; i++) {
        rl_vec3 p = load(mesh.position[i]);
        rl_vec3 ring = v3_scale(1.0 / hypot(p.x, p.z), v3(p.x, 0.0, p.z));
        check_near(v3_length(v3_sub(v3_scale(1.0 / 0.3, v3_sub(p, ring)), load(mesh.normal[i]))), 0.0, 1e-6);
    }
    rl_mesh_clear(&mesh);
}

static void test_bounds(void **state)
{
    (void)state;
    struct rl_mesh mesh;
    rl_vec3 low, high, centre;
    double radius;
    check_ok(rl_shape_build(&mesh, RL_SHAPE_TEAPOT, 32, 0.0, &error), &error);
    rl_mesh_bounds(&mesh, &low, &high, &centre, &radius);
    /* What shapes.h says of it. */
    check_near(low.y, 0.0, 1e-7);
    check_near(high.y, 0.85, 0.005);
    check_near(high.z - low.z, 1.14, 0.01);
    check_near(high.x - low.x, 1.83, 0.01);
    assert_true(high.x > -low.x); /* the spout reaches farther than the handle */
    for (size_t i = 0; i < mesh.n_vertices; i++)
        assert_true(v3_length(v3_sub(load(mesh.position[i]), centre)) <= radius);
    rl_mesh_clear(&mesh);

    struct rl_mesh empty = {0};
    rl_mesh_bounds(&empty, &low, &high, &centre, &radius);
    check_near(radius, 0.0, 0.0);
}

static void test_refused(void **state)
{
    (void)state;
    struct rl_mesh mesh;
    check_fails(rl_shape_build(&mesh, RL_SHAPE_SPHERE, 0, 0.0, &error), &error, RL_ERR_INPUT,
                "found 0, expected 1 to 512");
    check_fails(rl_shape_build(&mesh, RL_SHAPE_SPHERE, 513, 0.0, &error), &error, RL_ERR_INPUT, "found 513");
    check_fails(rl_shape_build(&mesh, RL_SHAPE_TORUS, 4, 0.0, &error), &error, RL_ERR_INPUT,
                "minor: found 0");
    check_fails(rl_shape_build(&mesh, RL_SHAPE_TORUS, 4, 1.0, &error), &error, RL_ERR_INPUT,
                "minor: found 1");
    check_fails(rl_shape_build(&mesh, RL_SHAPE_TORUS, 4, NAN, &error), &error, RL_ERR_INPUT, "minor");
    check_fails(rl_shape_build(&mesh, RL_SHAPE_MESH, 4, 0.5, &error), &error, RL_ERR_INPUT, "not a built-in");
    assert_null(mesh.position);
    assert_null(rl_shape_name((enum rl_shape)99));
    assert_string_equal(rl_shape_name(RL_SHAPE_TEAPOT), "teapot");
}

/* A mesh of n triangles among the corners of a tetrahedron, each with vertices of its own. */
static void make_loose(struct rl_mesh *mesh, const uint32_t (*triangle)[3], size_t n)
{
    static const float corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    check_ok(rl_mesh_allocate(mesh, 3 * n, n, &error), &error);
    for (size_t i = 0; i < 3 * n; i++) {
        for (int c = 0; c < 3; c++)
            mesh->position[i][c] = corner[triangle[i / 3][i % 3]][c];
        /* The two zeros are one place. */
        mesh->position[i][0] = mesh->position[i][0] == 0.0f && i % 2 ? -0.0f : mesh->position[i][0];
        mesh->triangle[i / 3][i % 3] = (uint32_t)i;
    }
}

static void test_closed(void **state)
{
    (void)state;
    static const struct {
        enum rl_shape shape;
        bool closed;
    } shape[] = {{RL_SHAPE_SPHERE, true},
                 {RL_SHAPE_TORUS, true},
                 {RL_SHAPE_PLANE, false},
                 {RL_SHAPE_DISC, false},
                 {RL_SHAPE_TEAPOT, false}};
    struct rl_mesh mesh;
    bool closed;
    for (size_t i = 0; i < sizeof shape / sizeof shape[0]; i++)
        for (int tessellation = 1; tessellation <= 13; tessellation += 4) {
            check_ok(rl_shape_build(&mesh, shape[i].shape, tessellation, 0.3, &error), &error);
            check_ok(rl_mesh_closed(&closed, &mesh, &error), &error);
            assert_int_equal(closed, shape[i].closed);
            rl_mesh_clear(&mesh);
        }
    static const struct {
        uint32_t triangle[6][3];
        size_t n;
        bool closed;
    } loose[] = {
        {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, 4, true},
        {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}, 3, false},                       /* a hole */
        {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}, 4, false},            /* one the wrong way round */
        {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {1, 1, 2}}, 5, true},  /* one without area */
        {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {1, 2, 3}}, 5, false}, /* one twice */
        {{{1, 1, 2}}, 1, false},                                             /* nothing */
    };
    for (size_t i = 0; i < sizeof loose / sizeof loose[0]; i++) {
        make_loose(&mesh, loose[i].triangle, loose[i].n);
        check_ok(rl_mesh_closed(&closed, &mesh, &error), &error);
        assert_int_equal(closed, loose[i].closed);
        rl_mesh_clear(&mesh);
    }
}

/* A tetrahedron from beyond one of its faces, from its corner's side, and from inside; an edge-on face counts as turned away. */
static void test_back_faces(void **state)
{
    (void)state;
    static const uint32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    static const struct {
        rl_vec3 eye;
        size_t back;
    } row[] = {{{5.0, 5.0, 5.0}, 3},
               {{-5.0, -5.0, -5.0}, 1},
               {{0.1, 0.1, 0.1}, 4},
               {{0.1, 0.1, -5.0}, 3},
               {{0.0, 0.1, -5.0}, 3}};
    struct rl_mesh mesh;
    make_loose(&mesh, faces, 4);
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
        assert_int_equal(rl_mesh_back_faces(&mesh, row[i].eye), row[i].back);
    rl_mesh_clear(&mesh);
}

/* As OpenGL draws triangles that are shaded as a whole: no last corner twice, the same corners in the same order, and hardly more vertices. */
static void test_own_last(void **state)
{
    (void)state;
    static const enum rl_shape shapes[] = {RL_SHAPE_SPHERE, RL_SHAPE_TORUS, RL_SHAPE_PLANE, RL_SHAPE_DISC};
    for (size_t s = 0; s < sizeof shapes / sizeof shapes[0]; s++) {
        struct rl_mesh mesh;
        size_t n = 0, counted = 0;
        check_ok(rl_shape_build(&mesh, shapes[s], 12, 0.3, &error), &error);
        uint32_t(*turned)[3] = malloc(mesh.n_triangles * sizeof *turned);
        uint32_t *twin = malloc(mesh.n_triangles * sizeof *twin);
        bool *last = calloc(mesh.n_vertices + mesh.n_triangles, sizeof *last);
        assert_true(turned && twin && last);
        check_ok(rl_mesh_own_last(&n, turned, twin, &mesh, &error), &error);
        check_ok(rl_mesh_own_last(&counted, NULL, NULL, &mesh, &error), &error);
        assert_int_equal(n, counted);
        assert_true(mesh.n_vertices + n <= mesh.n_triangles + mesh.n_triangles / 8 + 3);
        for (size_t t = 0; t < mesh.n_triangles; t++) {
            uint32_t corner[3];
            assert_in_range(turned[t][2], 0, mesh.n_vertices + n - 1);
            assert_false(last[turned[t][2]]);
            last[turned[t][2]] = true;
            for (int k = 0; k < 3; k++)
                corner[k] =
                    turned[t][k] < mesh.n_vertices ? turned[t][k] : twin[turned[t][k] - mesh.n_vertices];
            int first = 0;
            while (first < 3 && corner[0] != mesh.triangle[t][first])
                first++;
            for (int k = 0; k < 3; k++)
                assert_int_equal(corner[k], mesh.triangle[t][(first + k) % 3]);
        }
        free(turned);
        free(twin);
        free(last);
        rl_mesh_clear(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sizes),    cmocka_unit_test(test_normals), cmocka_unit_test(test_bounds),
        cmocka_unit_test(test_refused),  cmocka_unit_test(test_closed),  cmocka_unit_test(test_back_faces),
        cmocka_unit_test(test_own_last),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
