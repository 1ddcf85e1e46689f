/* Scale, stretch, rotation and translation of objects and lights. */
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "scene/scene_build.h"

#define SCALE_MIN 1e-6
#define SCALE_MAX 1e6

/* product = about x by angle[0], then y by angle[1], then z by angle[2], in degrees: Rz Ry Rx. */
static void rotation(double product[3][3], const double angle[3])
{
    double c[3], s[3];
    for (int i = 0; i < 3; i++) {
        c[i] = cos(angle[i] * RL_PI / 180.0);
        s[i] = sin(angle[i] * RL_PI / 180.0);
    }
    const double rows[3][3] = {
        {c[2] * c[1], c[2] * s[1] * s[0] - s[2] * c[0], c[2] * s[1] * c[0] + s[2] * s[0]},
        {s[2] * c[1], s[2] * s[1] * s[0] + c[2] * c[0], s[2] * s[1] * c[0] - c[2] * s[0]},
        {-s[1], c[1] * s[0], c[1] * c[0]},
    };
    memcpy(product, rows, sizeof rows);
}

int rl_build_placement(struct rl_placement *placement, const struct rl_scene_builder *b,
                       const struct rl_raw_placement *raw, const char *key)
{
    char path[RL_YAML_KEY_MAX];
    double scale[3] = {1.0, 1.0, 1.0}, angle[3] = {0.0, 0.0, 0.0};
    int status = RL_OK;
    if (raw->scale) {
        rl_yaml_key(path, key, "scale");
        status = rl_build_range(b, path, *raw->scale, SCALE_MIN, SCALE_MAX);
        scale[0] = scale[1] = scale[2] = *raw->scale;
    }
    if (status == RL_OK && raw->stretch) {
        rl_yaml_key(path, key, "stretch");
        status = rl_build_triple(b, path, raw->stretch, SCALE_MIN, SCALE_MAX);
        for (int i = 0; i < 3; i++)
            scale[i] *= raw->stretch[i];
    }
    if (status == RL_OK && raw->rotate) {
        rl_yaml_key(path, key, "rotate");
        status = rl_build_triple(b, path, raw->rotate, -3600.0, 3600.0);
        memcpy(angle, raw->rotate, sizeof angle);
    }
    placement->is_identity = !raw->scale && !raw->stretch && !raw->rotate && !raw->translate;
    placement->translate = v3(0.0, 0.0, 0.0);
    if (status == RL_OK && raw->translate) {
        rl_yaml_key(path, key, "translate");
        status = rl_build_triple(b, path, raw->translate, -RL_LENGTH_MAX, RL_LENGTH_MAX);
        placement->translate = v3(raw->translate[0], raw->translate[1], raw->translate[2]);
    }
    rotation(placement->linear, angle);
    double determinant = scale[0] * scale[1] * scale[2];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            placement->cofactor[i][j] = placement->linear[i][j] * determinant / scale[j];
            placement->linear[i][j] *= scale[j];
        }
    return status;
}

static rl_vec3 apply(const double m[3][3], rl_vec3 p)
{
    return v3(m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z, m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
              m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z);
}

rl_vec3 rl_place_point(const struct rl_placement *placement, rl_vec3 p)
{
    return v3_add(apply(placement->linear, p), placement->translate);
}

static rl_vec3 load(const float from[3])
{
    return v3(from[0], from[1], from[2]);
}

static void store(float to[3], rl_vec3 from)
{
    to[0] = (float)from.x;
    to[1] = (float)from.y;
    to[2] = (float)from.z;
}

void rl_place_mesh(const struct rl_placement *placement, struct rl_mesh *mesh)
{
    if (placement->is_identity)
        return;
    for (size_t i = 0; i < mesh->n_vertices; i++) {
        store(mesh->position[i], rl_place_point(placement, load(mesh->position[i])));
        store(mesh->normal[i], v3_normalize(apply(placement->cofactor, load(mesh->normal[i]))));
    }
}

int rl_build_extent(const struct rl_scene_builder *b, const char *key, rl_vec3 centre, double radius)
{
    double reach = v3_length(centre) + radius;
    if (reach <= RL_LENGTH_MAX)
        return RL_OK;
    return rl_yaml_fail(b->tree, b->error, key, "found it to reach %.3g from the origin, expected at most %g",
                        reach, RL_LENGTH_MAX);
}

/* The folder of the scene file and `file`, unless that is absolute. */
static int join_path(char joined[PATH_MAX], const char *scene_path, const char *file)
{
    const char *slash = strrchr(scene_path, '/');
    int folder = slash && file[0] != '/' ? (int)(slash + 1 - scene_path) : 0;
    int n = snprintf(joined, PATH_MAX, "%.*s%s", folder, scene_path, file);
    return n > 0 && n < PATH_MAX ? RL_OK : RL_ERR_INPUT;
}

int rl_build_mesh_file(const struct rl_scene_builder *b, struct rl_mesh *mesh, const char *file,
                       const char *key)
{
    char path[PATH_MAX];
    struct rl_error mesh_error = {0};
    if (join_path(path, b->scene->path, file) != RL_OK)
        return rl_yaml_fail_value(b->tree, b->error, key, "a shorter path");
    int status = rl_mesh_load(mesh, &b->scene->hash, path, &mesh_error);
    if (status == RL_ERR_INPUT)
        return rl_yaml_fail(b->tree, b->error, key, "%s", mesh_error.message);
    if (status != RL_OK)
        return rl_fail(b->error, mesh_error.status, "%s", mesh_error.message);
    for (size_t i = 0; i < mesh->n_vertices; i++)
        for (int c = 0; c < 3; c++)
            if (fabs((double)mesh->position[i][c]) > RL_LENGTH_MAX)
                return rl_yaml_fail(b->tree, b->error, key,
                                    "found the coordinate %g in the mesh, expected at most %g",
                                    (double)mesh->position[i][c], RL_LENGTH_MAX);
    return RL_OK;
}
