/* Triangles in homogeneous coordinates (see raster.h). */
#include "reference/raster.h"

#include <math.h>

/* A corner relative to the eye, along the camera's right, up and forward. */
static rl_vec3 seen_from(const struct rl_camera *c, const float p[3])
{
    rl_vec3 d = v3_sub(v3(p[0], p[1], p[2]), c->position);
    return v3(v3_dot(d, c->right), v3_dot(d, c->up), v3_dot(d, c->forward));
}

/* What all triangles share. */
struct view {
    const struct rl_camera *camera;
    const struct rl_raster_options *options;
    double half; /* of the film's height, 1 before the eye */
};

static struct view make_view(const struct rl_scene *scene, const struct rl_raster_options *options)
{
    return (struct view){&scene->camera, options, tan(0.5 * scene->camera.fov_y)};
}

/* The ray through a place of the picture, 1 long along the view direction. */
static rl_vec3 ray_at(const struct view *view, int x, int y)
{
    const struct rl_raster_options *o = view->options;
    double scale = view->half / o->height;
    return v3(scale * (2.0 * (x + 0.5 + o->dx) - o->width), scale * (o->height - 2.0 * (y + 0.5 + o->dy)),
              1.0);
}

/* a_i = row[i].d; false: seen edge-on, or from behind where that is culled. Right, up and forward are left-handed: the volume of a triangle
 * that shows its front is positive. */
static bool make_rows(rl_vec3 row[3], const rl_vec3 v[3], bool culling)
{
    double volume = v3_dot(v[0], v3_cross(v[1], v[2]));
    if (volume == 0.0 || (culling && volume < 0.0))
        return false;
    for (int i = 0; i < 3; i++)
        row[i] = v3_scale(1.0 / volume, v3_cross(v[(i + 1) % 3], v[(i + 2) % 3]));
    return true;
}

/* The pixels that the triangle may cover, to before x1 and y1: all where a corner does not lie before the eye. */
struct box {
    int x0, y0, x1, y1;
};

static int within(double at, int size)
{
    return (int)fmax(0.0, fmin(at, size));
}

static struct box bound(const struct view *view, const rl_vec3 v[3])
{
    /* Of a pixel; rounding is less than this by far. */
    const double slack = 1e-6;
    const struct rl_raster_options *o = view->options;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < 3; i++) {
        if (!(v[i].z > 0.0))
            return (struct box){0, 0, o->width, o->height};
        double scale = 0.5 * o->height / (view->half * v[i].z);
        /* In pixels, those whose ray passes through a corner being whole numbers. */
        const double at[2] = {0.5 * o->width + scale * v[i].x - 0.5 - o->dx,
                              0.5 * o->height - scale * v[i].y - 0.5 - o->dy};
        for (int k = 0; k < 2; k++) {
            low[k] = at[k] < low[k] ? at[k] : low[k];
            high[k] = at[k] > high[k] ? at[k] : high[k];
        }
    }
    return (struct box){within(ceil(low[0] - slack), o->width), within(ceil(low[1] - slack), o->height),
                        within(floor(high[0] + slack) + 1.0, o->width),
                        within(floor(high[1] + slack) + 1.0, o->height)};
}

static double depth_of(const struct rl_camera *c, bool reversed, double z)
{
    double n = c->near_plane, f = c->far_plane;
    return (reversed ? n * (f - z) : f * (z - n)) / (z * (f - n));
}

/* What the depth buffer keeps of z; the less, the nearer. */
static double kept(const struct rl_camera *c, const struct rl_raster_options *o, double z)
{
    if (o->depth_bits == 0)
        return z;
    double depth = depth_of(c, o->reversed_depth, z);
    if (o->depth_bits == 32)
        depth = (double)(float)depth;
    else
        depth = nearbyint(depth * (ldexp(1.0, o->depth_bits) - 1.0));
    return o->reversed_depth ? -depth : depth;
}

/* What it holds before anything is drawn. */
static double cleared(const struct rl_raster_options *o)
{
    if (o->depth_bits == 0)
        return INFINITY;
    if (o->reversed_depth)
        return 0.0;
    return o->depth_bits == 32 ? 1.0 : ldexp(1.0, o->depth_bits) - 1.0;
}

/* Where a surface at z is nearer than what the pixel shows, it shows now. */
static void meet(struct rl_raster_pixel *p, double z, uint32_t object, uint32_t triangle,
                 const struct view *view)
{
    const struct rl_camera *c = view->camera;
    const struct rl_raster_options *o = view->options;
    if (!(z >= c->near_plane && z <= c->far_plane))
        return;
    if (!(kept(c, o, z) < (p->object != 0 ? kept(c, o, p->z) : cleared(o)))) {
        p->gap = fmin(p->gap, z - p->z);
        return;
    }
    *p = (struct rl_raster_pixel){object, triangle, z, p->object != 0 ? p->z - z : INFINITY};
}

static void draw_triangle(struct rl_raster_pixel *pixel, const rl_vec3 v[3], uint32_t object,
                          uint32_t triangle, const struct view *view)
{
    rl_vec3 row[3];
    if (!make_rows(row, v, view->options->culling))
        return;
    const struct box box = bound(view, v);
    for (int y = box.y0; y < box.y1; y++)
        for (int x = box.x0; x < box.x1; x++) {
            rl_vec3 d = ray_at(view, x, y);
            double a = v3_dot(row[0], d), b = v3_dot(row[1], d), e = v3_dot(row[2], d);
            if (a >= 0.0 && b >= 0.0 && e >= 0.0)
                meet(&pixel[(size_t)y * (size_t)view->options->width + (size_t)x], 1.0 / (a + b + e), object,
                     triangle, view);
        }
}

static void corners(rl_vec3 v[3], const struct rl_scene *scene, size_t object, size_t triangle)
{
    const struct rl_mesh *mesh = &scene->object[object].mesh;
    for (int i = 0; i < 3; i++)
        v[i] = seen_from(&scene->camera, mesh->position[mesh->triangle[triangle][i]]);
}

void rl_raster_draw(struct rl_raster_pixel *pixel, const struct rl_scene *scene,
                    const struct rl_raster_options *options)
{
    const struct view view = make_view(scene, options);
    for (size_t i = 0; i < (size_t)options->width * (size_t)options->height; i++)
        pixel[i] = (struct rl_raster_pixel){.z = INFINITY, .gap = INFINITY};
    for (size_t i = 0; i < scene->n_objects; i++)
        for (size_t t = 0; t < scene->object[i].mesh.n_triangles; t++) {
            rl_vec3 v[3];
            corners(v, scene, i, t);
            draw_triangle(pixel, v, (uint32_t)(i + 1), (uint32_t)(t + 1), &view);
        }
}

double rl_raster_depth(const struct rl_scene *scene, const struct rl_raster_options *options, uint32_t object,
                       uint32_t triangle, int x, int y)
{
    const struct view view = make_view(scene, options);
    rl_vec3 v[3], row[3], d = ray_at(&view, x, y);
    corners(v, scene, object - 1, triangle - 1);
    if (!make_rows(row, v, false))
        return INFINITY;
    return 1.0 / (v3_dot(row[0], d) + v3_dot(row[1], d) + v3_dot(row[2], d));
}

double rl_raster_resolution(const struct rl_camera *camera, const struct rl_raster_options *options, double z)
{
    double n = camera->near_plane, f = camera->far_plane;
    float depth = (float)fabs(depth_of(camera, options->reversed_depth, z));
    double step = options->depth_bits == 32 ? (double)(nextafterf(depth, INFINITY) - depth)
                                            : 1.0 / (ldexp(1.0, options->depth_bits) - 1.0);
    return z * z * (f - n) / (f * n) * step;
}
