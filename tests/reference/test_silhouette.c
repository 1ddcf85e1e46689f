/* Silhouettes of meshes whose edges can be counted by hand. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "reference/silhouette.h"
#include "support/check.h"

/* The cube [0, 1]^3 as 12 triangles, each with vertices of its own; only the first `faces` of its 6 faces. */
static void make_cube(struct rl_mesh *mesh, int faces)
{
    static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    static const int split[6] = {0, 1, 2, 0, 2, 3};
    struct rl_error error;
    size_t n = 6 * (size_t)faces;
    check_ok(rl_mesh_allocate(mesh, n, n / 3, &error), &error);
    for (size_t i = 0; i < n; i++) {
        int v = face[i / 6][split[i % 6]];
        for (int c = 0; c < 3; c++)
            mesh->position[i][c] = (float)(v >> c & 1);
        mesh->triangle[i / 3][i % 3] = (uint32_t)i;
    }
}

static size_t count(const struct rl_mesh_edges *edges, rl_vec3 P)
{
    uint32_t found[64];
    unsigned char facing[12];
    assert_true(edges->n_edges <= 64);
    return rl_mesh_silhouette(found, facing, edges, P);
}

static void test_counts(void **state)
{
    (void)state;
    static const struct {
        int faces;
        size_t edges, borders;
        rl_vec3 P;
        size_t silhouette;
    } row[] = {
        {6, 18, 0, {0.5, 0.5, 3.0}, 4}, /* one face seen */
        {6, 18, 0, {0.5, 3.0, 3.0}, 6}, /* two */
        {6, 18, 0, {3.0, 3.0, 3.0}, 6}, /* three */
        {6, 18, 0, {0.5, 0.5, 0.5}, 0}, /* from within */
        {5, 17, 4, {0.5, 0.5, 3.0}, 7}, /* the face x = 1 missing: a border of 4, and 3 edges of the top */
        {1, 5, 4, {0.5, 0.5, -3.0}, 4}, /* a square: its diagonal never counts */
        {1, 5, 4, {0.5, 0.5, 3.0}, 4},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct rl_mesh mesh;
        struct rl_mesh_edges edges;
        struct rl_error error;
        make_cube(&mesh, row[i].faces);
        check_ok(rl_mesh_edges_make(&edges, &mesh, &error), &error);
        assert_int_equal(edges.n_edges, row[i].edges);
        assert_int_equal(edges.n_borders, row[i].borders);
        assert_int_equal(count(&edges, row[i].P), row[i].silhouette);
        rl_mesh_edges_clear(&edges);
        rl_mesh_clear(&mesh);
    }
}

/* A triangle with two corners at one place covers nothing and shares its edge with two others; an edge of three always counts. */
static void test_odd_triangles(void **state)
{
    (void)state;
    static const float position[6][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {1, 0, 0}};
    static const uint32_t triangle[4][3] = {{0, 1, 2}, {1, 5, 0}, {0, 3, 5}, {0, 1, 4}};
    for (size_t n = 3; n <= 4; n++) {
        struct rl_mesh mesh;
        struct rl_mesh_edges edges;
        struct rl_error error;
        check_ok(rl_mesh_allocate(&mesh, 6, n, &error), &error);
        memcpy(mesh.position, position, sizeof position);
        memcpy(mesh.triangle, triangle, n * sizeof triangle[0]);
        check_ok(rl_mesh_edges_make(&edges, &mesh, &error), &error);
        assert_int_equal(edges.n_edges, n == 3 ? 5 : 7);
        assert_int_equal(edges.n_borders, n == 3 ? 4 : 7);
        assert_int_equal(count(&edges, v3(0.2, 0.0, 2.0)), edges.n_borders);
        rl_mesh_edges_clear(&edges);
        rl_mesh_clear(&mesh);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_counts), cmocka_unit_test(test_odd_triangles)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
