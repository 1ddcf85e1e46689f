/* The camera: from the scene file, its planes, rays and matrix (see scene.h). */
#include <string.h>

#include "scene/scene_build.h"

/* Depth buffers resolve planes this far apart well. */
#define NEAR_TO_FAR 1e-3
/* Relative distance between the planes from which on depth has a scale. */
#define PLANES_APART 1e-6
/* sin of the angle between view direction and `up` below which the picture's upright is arbitrary. */
#define PARALLEL 1e-6

static rl_vec3 from(const double v[3])
{
    return v3(v[0], v[1], v[2]);
}

int rl_build_camera(const struct rl_scene_builder *b)
{
    static const double y_axis[3] = {0.0, 1.0, 0.0};
    const struct rl_raw_camera *raw = &b->raw->camera;
    const double *up = raw->up ? raw->up : y_axis;
    struct rl_camera *camera = &b->scene->camera;
    int status = rl_build_triple(b, "camera.position", raw->position, -RL_LENGTH_MAX, RL_LENGTH_MAX);
    if (status == RL_OK)
        status = rl_build_triple(b, "camera.target", raw->target, -RL_LENGTH_MAX, RL_LENGTH_MAX);
    if (status == RL_OK)
        status = rl_build_triple(b, "camera.up", up, -RL_LENGTH_MAX, RL_LENGTH_MAX);
    if (status != RL_OK)
        return status;
    rl_vec3 direction = v3_sub(from(raw->target), from(raw->position));
    camera->position = from(raw->position);
    camera->forward = v3_normalize(direction);
    if (!(v3_length(camera->forward) > 0.0))
        return rl_yaml_fail(b->tree, b->error, "camera.target",
                            "found the camera's own position, expected a point to look at");
    rl_vec3 right = v3_cross(camera->forward, v3_normalize(from(up)));
    if (!(v3_length(right) > PARALLEL))
        return rl_yaml_fail(
            b->tree, b->error, raw->up ? "camera.up" : "camera.target",
            "found the view direction parallel to up (%g, %g, %g), expected an angle between them", up[0],
            up[1], up[2]);
    camera->right = v3_normalize(right);
    camera->up = v3_cross(camera->right, camera->forward);
    /* What is farther than this from 0 and 180 degrees has a tangent that makes sense. */
    status = rl_build_range(b, "camera.field-of-view", raw->field_of_view, 0.01, 179.0);
    camera->fov_y = raw->field_of_view * RL_PI / 180.0;
    return status;
}

bool rl_camera_misses(const struct rl_camera *camera, int width, int height, rl_vec3 centre, double radius)
{
    rl_vec3 d = v3_sub(centre, camera->position);
    double x = fabs(v3_dot(d, camera->right)), y = fabs(v3_dot(d, camera->up));
    double z = v3_dot(d, camera->forward), r = radius + RL_VIEW_SLACK * (v3_length(d) + radius);
    double t_y = tan(0.5 * camera->fov_y), t_x = t_y * width / height;
    return z + r <= 0.0 || x - t_x * z >= r * sqrt(1.0 + t_x * t_x) ||
           y - t_y * z >= r * sqrt(1.0 + t_y * t_y);
}

/* Tight round the objects that are in the view: one behind the eye would pull the near plane to it, one far out to the side push it away,
 * and neither is seen. A plane that the file gives (0: it does not) stays. */
static void fit_planes(const struct rl_scene *scene, int width, int height, double *near, double *far)
{
    const struct rl_camera *camera = &scene->camera;
    double nearest = HUGE_VAL, farthest = 0.0;
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_object *object = &scene->object[i];
        if (rl_camera_misses(camera, width, height, object->centre, object->radius))
            continue;
        double depth = v3_dot(v3_sub(object->centre, camera->position), camera->forward);
        nearest = fmin(nearest, depth - object->radius);
        farthest = fmax(farthest, depth + object->radius);
    }
    /* Nothing is seen: any planes will do. */
    if (!(farthest > 0.0)) {
        nearest = 0.0;
        farthest = *near > 0.0 ? 2.0 * *near : 1.0;
    }
    /* A little slack keeps a surface at the very end in the picture. */
    if (!(*far > 0.0))
        *far = 1.001 * farthest;
    if (!(*near > 0.0))
        *near = fmax(0.999 * nearest, NEAR_TO_FAR * *far);
}

void rl_scene_fit_planes(struct rl_scene *scene, int width, int height)
{
    struct rl_camera *camera = &scene->camera;
    double near = camera->near_given ? camera->near_plane : 0.0;
    double far = camera->far_given ? camera->far_plane : 0.0;
    fit_planes(scene, width, height, &near, &far);
    /* If not, all that such a film shows is nearer than the one that is given, or farther: the others are as good. */
    if (far >= (1.0 + PLANES_APART) * near) {
        camera->near_plane = near;
        camera->far_plane = far;
    }
}

/* Whether the planes are apart; if not, the message is about one that the file gives. */
static int check_planes(const struct rl_scene_builder *b, double near, double far)
{
    const struct rl_raw_camera *raw = &b->raw->camera;
    if (far >= (1.0 + PLANES_APART) * near)
        return RL_OK;
    if (raw->near && raw->far)
        return rl_yaml_fail_value(b->tree, b->error, "camera.near", "less than far, %g", far);
    if (raw->near)
        return rl_yaml_fail_value(b->tree, b->error, "camera.near", "less than %g, where the objects end",
                                  far);
    return rl_yaml_fail_value(b->tree, b->error, "camera.far", "more than %g, where the objects begin", near);
}

int rl_build_camera_planes(const struct rl_scene_builder *b)
{
    const struct rl_raw_camera *raw = &b->raw->camera;
    struct rl_camera *camera = &b->scene->camera;
    double near = raw->near ? *raw->near : 0.0, far = raw->far ? *raw->far : 0.0;
    int status = RL_OK;
    if (raw->near)
        status = rl_build_range(b, "camera.near", *raw->near, 1.0 / RL_LENGTH_MAX, RL_LENGTH_MAX);
    if (status == RL_OK && raw->far)
        status = rl_build_range(b, "camera.far", *raw->far, 1.0 / RL_LENGTH_MAX, RL_LENGTH_MAX);
    if (status != RL_OK)
        return status;
    fit_planes(b->scene, b->scene->width, b->scene->height, &near, &far);
    camera->near_given = raw->near;
    camera->far_given = raw->far;
    camera->near_plane = near;
    camera->far_plane = far;
    return check_planes(b, near, far);
}

rl_vec3 rl_camera_ray(const struct rl_camera *camera, int width, int height, int x, int y)
{
    double half = tan(0.5 * camera->fov_y);
    double right = half * (2.0 * (x + 0.5) - width) / height;
    double up = half * (height - 2.0 * (y + 0.5)) / height;
    return v3_normalize(v3_madd(v3_madd(camera->forward, right, camera->right), up, camera->up));
}

void rl_camera_matrix(const struct rl_camera *camera, int width, int height, bool reversed, double matrix[16])
{
    /* Rows of clip = projection x view: x along right, y along up, z and w along forward. */
    double scale = 1.0 / tan(0.5 * camera->fov_y);
    double n = camera->near_plane, f = camera->far_plane;
    double depth_scale = (reversed ? -n : f + n) / (f - n);
    double depth_offset = (reversed ? f * n : -2.0 * f * n) / (f - n);
    const rl_vec3 rows[4] = {
        v3_scale(scale * height / width, camera->right),
        v3_scale(scale, camera->up),
        v3_scale(depth_scale, camera->forward),
        camera->forward,
    };
    const double offset[4] = {0.0, 0.0, depth_offset, 0.0};
    for (int r = 0; r < 4; r++) {
        matrix[r] = rows[r].x;
        matrix[4 + r] = rows[r].y;
        matrix[8 + r] = rows[r].z;
        matrix[12 + r] = offset[r] - v3_dot(rows[r], camera->position);
    }
}
