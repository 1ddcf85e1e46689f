/* Scene files: the input is the YAML text. What loads is planned, too.
 *
 * Meshes that a scene names are not read (mesh.c has what we read of them): a file of any name is a tetrahedron, and "missing" is none.
 * Shapes are made of few triangles, whatever the file asks for. Both by the linker's --wrap. */
#include <math.h>

#include "base/hash.h"
#include "fuzz/harness.h"
#include "scene/plan.h"
#include "scene/shapes.h"

int __wrap_rl_mesh_load(struct rl_mesh *mesh, uint64_t *hash, const char *path, struct rl_error *error);
int __real_rl_shape_build(struct rl_mesh *mesh, enum rl_shape shape, int tessellation, double minor,
                          struct rl_error *error);
int __wrap_rl_shape_build(struct rl_mesh *mesh, enum rl_shape shape, int tessellation, double minor,
                          struct rl_error *error);

int __wrap_rl_mesh_load(struct rl_mesh *mesh, uint64_t *hash, const char *path, struct rl_error *error)
{
    static const float position[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const uint32_t triangle[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    if (hash)
        *hash = rl_hash_bytes(*hash, position, sizeof position);
    if (strstr(path, "missing"))
        return rl_fail(error, RL_ERR_INPUT, "%s: cannot open", path);
    int status = rl_mesh_allocate(mesh, 4, 4, error);
    if (status != RL_OK)
        return status;
    memcpy(mesh->position, position, sizeof position);
    memcpy(mesh->normal, position, sizeof position);
    mesh->normal[0][0] = -1.0F;
    memcpy(mesh->triangle, triangle, sizeof triangle);
    return RL_OK;
}

int __wrap_rl_shape_build(struct rl_mesh *mesh, enum rl_shape shape, int tessellation, double minor,
                          struct rl_error *error)
{
    return __real_rl_shape_build(mesh, shape, tessellation < 4 ? tessellation : 4, minor, error);
}

static void check_finite(const double *value, size_t n)
{
    for (size_t i = 0; i < n; i++)
        FUZZ_CHECK(isfinite(value[i]));
}

static void check_scene(const struct rl_scene *scene)
{
    double matrix[16];
    const struct rl_camera *camera = &scene->camera;
    FUZZ_CHECK(scene->width > 0 && scene->height > 0);
    FUZZ_CHECK(camera->near_plane > 0.0 && camera->near_plane < camera->far_plane);
    for (int reversed = 0; reversed < 2; reversed++) {
        rl_camera_matrix(camera, scene->width, scene->height, reversed != 0, matrix);
        check_finite(matrix, 16);
    }
    for (size_t i = 0; i < scene->n_lights; i++) {
        const struct rl_light *light = &scene->light[i];
        const double figure[] = {light->centroid.x,  light->centroid.y,  light->centroid.z,
                                 light->centre.x,    light->centre.y,    light->centre.z,
                                 light->radiance[0], light->radiance[1], light->radiance[2]};
        check_finite(figure, sizeof figure / sizeof *figure);
        FUZZ_CHECK(light->radius > 0.0 && light->area > 0.0 && isfinite(light->radius + light->area));
    }
    for (size_t i = 0; i < scene->n_sources; i++)
        check_finite(scene->source[i].strength, 3);
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_object *object = &scene->object[i];
        FUZZ_CHECK(object->material >= 0 && (size_t)object->material < scene->n_materials);
        FUZZ_CHECK(isfinite(object->radius));
    }
}

static void check_plan(const struct rl_scene *scene)
{
    struct rl_plan plan;
    struct rl_lights lights = {0};
    struct rl_error error = {0};
    int status = rl_plan_make(&plan, scene, &scene->settings, &error);
    fuzz_check_error(status, &error);
    if (status != RL_OK)
        return;
    status = rl_plan_lights_make(&lights, &plan, scene, &error);
    FUZZ_CHECK(status == RL_OK);
    rl_scene_lights_clear(&lights);
    rl_plan_clear(&plan);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static char path[PATH_MAX];
    struct rl_scene scene;
    struct rl_error error = {0};
    fuzz_write(fuzz_path(path, "scene.yaml"), data, size);
    int status = rl_scene_load(&scene, path, &error);
    fuzz_check_error(status, &error);
    if (status != RL_OK)
        return 0;
    check_scene(&scene);
    check_plan(&scene);
    rl_scene_clear(&scene);
    return 0;
}
