/* Builds the shapes of shapes.h. Vertices are shared wherever the normal is the same, so that sphere and
 * torus are closed. */
#include "scene/shapes.h"

#include "scene/teapot.h"

static const char *const names[] = {
    [RL_SHAPE_SPHERE] = "sphere", [RL_SHAPE_TORUS] = "torus",   [RL_SHAPE_PLANE] = "plane",
    [RL_SHAPE_DISC] = "disc",     [RL_SHAPE_TEAPOT] = "teapot", [RL_SHAPE_MESH] = "mesh",
};

const char *rl_shape_name(enum rl_shape shape)
{
    return (size_t)shape < sizeof names / sizeof names[0] ? names[shape] : NULL;
}

static void set_vertex(struct rl_mesh *mesh, size_t i, rl_vec3 position, rl_vec3 normal)
{
    const double p[3] = {position.x, position.y, position.z}, n[3] = {normal.x, normal.y, normal.z};
    for (int c = 0; c < 3; c++) {
        mesh->position[i][c] = (float)p[c];
        mesh->normal[i][c] = (float)n[c];
    }
}

static void set_triangle(struct rl_mesh *mesh, size_t i, size_t a, size_t b, size_t c)
{
    mesh->triangle[i][0] = (uint32_t)a;
    mesh->triangle[i][1] = (uint32_t)b;
    mesh->triangle[i][2] = (uint32_t)c;
}

/* Azimuth about y, from +x towards +z: exact at the quarters, so that the shape is symmetric. */
static rl_vec3 around(size_t step, size_t quarter)
{
    double angle = RL_PI / 2.0 * (double)(step % quarter) / (double)quarter;
    double c = cos(angle), s = sin(angle);
    switch (step / quarter % 4) {
    case 0:
        return v3(c, 0.0, s);
    case 1:
        return v3(-s, 0.0, c);
    case 2:
        return v3(-c, 0.0, -s);
    default:
        return v3(s, 0.0, -c);
    }
}

/* Poles at y = 1 (vertex 0) and y = -1 (vertex 1), between them 2 n - 1 rings of 4 n. */
static int build_sphere(struct rl_mesh *mesh, size_t n, struct rl_error *error)
{
    size_t segments = 4 * n, rings = 2 * n - 1;
    int status = rl_mesh_allocate(mesh, 2 + rings * segments, 2 * rings * segments, error);
    if (status != RL_OK)
        return status;
    set_vertex(mesh, 0, v3(0.0, 1.0, 0.0), v3(0.0, 1.0, 0.0));
    set_vertex(mesh, 1, v3(0.0, -1.0, 0.0), v3(0.0, -1.0, 0.0));
    for (size_t i = 0; i < rings; i++) {
        rl_vec3 profile = around(i + 1, n); /* x: along the axis, z: away from it */
        for (size_t j = 0; j < segments; j++) {
            rl_vec3 p = v3_scale(profile.z, around(j, n));
            p.y = profile.x;
            set_vertex(mesh, 2 + i * segments + j, p, p);
        }
    }
    size_t t = 0;
    for (size_t j = 0; j < segments; j++) {
        size_t next = (j + 1) % segments, last = 2 + (rings - 1) * segments;
        set_triangle(mesh, t++, 0, 2 + next, 2 + j);
        set_triangle(mesh, t++, 1, last + j, last + next);
        for (size_t i = 0; i + 1 < rings; i++) {
            size_t upper = 2 + i * segments, lower = upper + segments;
            set_triangle(mesh, t++, upper + j, upper + next, lower + next);
            set_triangle(mesh, t++, upper + j, lower + next, lower + j);
        }
    }
    return RL_OK;
}

static int build_torus(struct rl_mesh *mesh, size_t n, double minor, struct rl_error *error)
{
    size_t segments = 4 * n;
    int status = rl_mesh_allocate(mesh, segments * segments, 2 * segments * segments, error);
    if (status != RL_OK)
        return status;
    size_t t = 0;
    for (size_t i = 0; i < segments; i++) {
        rl_vec3 out = around(i, n);
        size_t next_ring = (i + 1) % segments;
        for (size_t j = 0; j < segments; j++) {
            rl_vec3 tube = around(j, n); /* x: away from the axis, z: up */
            rl_vec3 normal = v3_madd(v3(0.0, tube.z, 0.0), tube.x, out);
            set_vertex(mesh, i * segments + j, v3_madd(out, minor, normal), normal);
            size_t next = (j + 1) % segments;
            size_t a = i * segments + j, b = i * segments + next;
            size_t c = next_ring * segments + next, d = next_ring * segments + j;
            set_triangle(mesh, t++, a, b, c);
            set_triangle(mesh, t++, a, c, d);
        }
    }
    return RL_OK;
}

static int build_plane(struct rl_mesh *mesh, size_t n, struct rl_error *error)
{
    int status = rl_mesh_allocate(mesh, (n + 1) * (n + 1), 2 * n * n, error);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i <= n; i++)
        for (size_t j = 0; j <= n; j++)
            set_vertex(mesh, i * (n + 1) + j,
                       v3(2.0 * (double)j / (double)n - 1.0, 0.0, 2.0 * (double)i / (double)n - 1.0),
                       v3(0.0, 1.0, 0.0));
    size_t t = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            size_t a = i * (n + 1) + j, below = a + n + 1;
            set_triangle(mesh, t++, a, below, below + 1);
            set_triangle(mesh, t++, a, below + 1, a + 1);
        }
    return RL_OK;
}

static int build_disc(struct rl_mesh *mesh, size_t n, struct rl_error *error)
{
    size_t segments = 4 * n;
    int status = rl_mesh_allocate(mesh, segments + 1, segments, error);
    if (status != RL_OK)
        return status;
    set_vertex(mesh, segments, v3(0.0, 0.0, 0.0), v3(0.0, 1.0, 0.0));
    for (size_t j = 0; j < segments; j++) {
        set_vertex(mesh, j, around(j, n), v3(0.0, 1.0, 0.0));
        set_triangle(mesh, j, segments, (j + 1) % segments, j);
    }
    return RL_OK;
}

int rl_shape_build(struct rl_mesh *mesh, enum rl_shape shape, int tessellation, double minor,
                   struct rl_error *error)
{
    *mesh = (struct rl_mesh){0};
    if (tessellation < RL_TESSELLATION_MIN || tessellation > RL_TESSELLATION_MAX)
        return rl_fail(error, RL_ERR_INPUT, "tessellation: found %d, expected %d to %d", tessellation,
                       RL_TESSELLATION_MIN, RL_TESSELLATION_MAX);
    size_t n = (size_t)tessellation;
    switch (shape) {
    case RL_SHAPE_SPHERE:
        return build_sphere(mesh, n, error);
    case RL_SHAPE_TORUS:
        if (!(minor > 0.0 && minor < 1.0))
            return rl_fail(error, RL_ERR_INPUT, "minor: found %g, expected a radius above 0 and below 1",
                           minor);
        return build_torus(mesh, n, minor, error);
    case RL_SHAPE_PLANE:
        return build_plane(mesh, n, error);
    case RL_SHAPE_DISC:
        return build_disc(mesh, n, error);
    case RL_SHAPE_TEAPOT:
        return rl_teapot_build(mesh, tessellation, error);
    case RL_SHAPE_MESH:
        break;
    }
    return rl_fail(error, RL_ERR_INPUT, "shape %d: not a built-in one", (int)shape);
}
