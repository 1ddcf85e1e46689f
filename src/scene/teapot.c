/* Evaluates and tessellates the teapot's bicubic Bezier patches.
 *
 * P(u, v) = sum b_i(v) b_j(u) p_ij with Bernstein's cubics b. The data's rows and columns are such that
 * dP/dv x dP/du points outwards on every patch. */
#include "scene/teapot.h"

#include <stdbool.h>

struct basis {
    double b[4], d[4]; /* Bernstein's cubics and their derivatives */
};

static struct basis cubics(double t)
{
    double s = 1.0 - t;
    return (struct basis){
        .b = {s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t},
        .d = {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t},
    };
}

/* The cubic in u that a patch is at one v, and its derivative by v: four control points each. */
struct isoline {
    rl_vec3 point[4], along_v[4];
};

static rl_vec3 combine(const double weight[4], const rl_vec3 point[4])
{
    rl_vec3 sum = v3_scale(weight[0], point[0]);
    for (int i = 1; i < 4; i++)
        sum = v3_madd(sum, weight[i], point[i]);
    return sum;
}

static struct isoline isoline(int patch, double v)
{
    struct basis basis = cubics(v);
    struct isoline line;
    for (int j = 0; j < 4; j++) {
        rl_vec3 column[4];
        for (int i = 0; i < 4; i++) {
            const double *p = rl_teapot_point[rl_teapot_patch[patch][4 * i + j]];
            column[i] = v3(p[0], p[1], p[2]);
        }
        line.point[j] = combine(basis.b, column);
        line.along_v[j] = combine(basis.d, column);
    }
    return line;
}

static void evaluate(const struct isoline *line, const struct basis *u, rl_vec3 *position, rl_vec3 *normal)
{
    *position = combine(u->b, line->point);
    rl_vec3 along_u = combine(u->d, line->point);
    rl_vec3 along_v = combine(u->b, line->along_v);
    /* On an edge v = 0 that is one point, dP/du = 0 and close by it is v d2P/dudv: the same direction. */
    if (v3_length(along_u) < 1e-9)
        along_u = combine(u->d, line->along_v);
    *normal = v3_normalize(v3_cross(along_v, along_u));
}

void rl_teapot_evaluate(int patch, double u, double v, rl_vec3 *position, rl_vec3 *normal)
{
    struct isoline line = isoline(patch, v);
    struct basis basis = cubics(u);
    evaluate(&line, &basis, position, normal);
}

static void store(float to[3], rl_vec3 from)
{
    to[0] = (float)from.x;
    to[1] = (float)from.y;
    to[2] = (float)from.z;
}

static bool same_place(const float a[3], const float b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Leaves out a triangle that has the lid's tip twice. */
static void add_triangle(struct rl_mesh *mesh, size_t a, size_t b, size_t c)
{
    const size_t corner[3] = {a, b, c};
    for (int i = 0; i < 3; i++)
        if (same_place(mesh->position[corner[i]], mesh->position[corner[(i + 1) % 3]]))
            return;
    for (int i = 0; i < 3; i++)
        mesh->triangle[mesh->n_triangles][i] = (uint32_t)corner[i];
    mesh->n_triangles++;
}

static void add_patch(struct rl_mesh *mesh, int patch, int tessellation)
{
    size_t row = (size_t)tessellation + 1;
    size_t first = (size_t)patch * row * row, next = first;
    for (int i = 0; i <= tessellation; i++) {
        struct isoline line = isoline(patch, (double)i / tessellation);
        for (int j = 0; j <= tessellation; j++, next++) {
            struct basis basis = cubics((double)j / tessellation);
            rl_vec3 position, normal;
            evaluate(&line, &basis, &position, &normal);
            store(mesh->position[next], position);
            store(mesh->normal[next], normal);
        }
    }
    for (size_t i = 0; i + 1 < row; i++)
        for (size_t j = 0; j + 1 < row; j++) {
            size_t a = first + i * row + j;
            add_triangle(mesh, a, a + row, a + row + 1);
            add_triangle(mesh, a, a + row + 1, a + 1);
        }
}

int rl_teapot_build(struct rl_mesh *mesh, int tessellation, struct rl_error *error)
{
    size_t n = (size_t)tessellation, patches = RL_TEAPOT_PATCHES;
    int status = rl_mesh_allocate(mesh, patches * (n + 1) * (n + 1), patches * 2 * n * n, error);
    if (status != RL_OK)
        return status;
    mesh->n_triangles = 0;
    for (int patch = 0; patch < RL_TEAPOT_PATCHES; patch++)
        add_patch(mesh, patch, tessellation);
    return RL_OK;
}
