/* Embree's part of the CPU renderer (see visible.h). */
#include "reference/visible.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct rl_visible {
    const struct rl_scene *scene;
    RTCDevice device;
    RTCScene world;
    bool culling;
};

/* A ray of rl_visible_point: RTCIntersectContext must come first. */
struct point_context {
    struct RTCIntersectContext embree;
    const struct rl_visible *visible;
    rl_vec3 origin, direction;
    bool collects;
    /* The nearest triangle collected so far, and where the ray meets its plane. */
    unsigned object, triangle;
    double t;
};

static void collect(struct point_context *context, const struct RTCHit *hit);

/* Rejects hits on back faces where they are culled, so that the ray goes on through them as the rasteriser does; and all of a ray that
 * collects, so that it goes on past what it has found. Embree's geometric normal is (v1 - v0) x (v2 - v0). */
static void filter_point(const struct RTCFilterFunctionNArguments *a)
{
    const struct RTCRay *ray = (const struct RTCRay *)a->ray;
    const struct RTCHit *hit = (const struct RTCHit *)a->hit;
    struct point_context *context = (struct point_context *)a->context;
    float facing = ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z;
    if (!(facing < 0.0f) && context->visible->culling) {
        a->valid[0] = 0;
    } else if (context->collects) {
        collect(context, hit);
        a->valid[0] = 0;
    }
}

static int attach_mesh(struct rl_visible *v, const struct rl_mesh *mesh, unsigned id, struct rl_error *error)
{
    RTCGeometry geometry = rtcNewGeometry(v->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                               sizeof *mesh->position, mesh->n_vertices);
    unsigned *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof *mesh->triangle, mesh->n_triangles);
    if (positions && indices) {
        memcpy(positions, mesh->position, mesh->n_vertices * sizeof *mesh->position);
        memcpy(indices, mesh->triangle, mesh->n_triangles * sizeof *mesh->triangle);
        rtcSetGeometryIntersectFilterFunction(geometry, filter_point);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(v->world, geometry, id);
    }
    rtcReleaseGeometry(geometry);
    if (!positions || !indices)
        return rl_fail_memory(error, "Embree's copy of a mesh");
    return RL_OK;
}

int rl_visible_make(struct rl_visible **out, const struct rl_scene *scene, const bool *drawn, bool culling,
                    struct rl_error *error)
{
    struct rl_visible *v = calloc(1, sizeof *v);
    *out = NULL;
    if (!v)
        return rl_fail_memory(error, "the CPU renderer");
    v->scene = scene;
    v->culling = culling;
    v->device = rtcNewDevice("verbose=0");
    if (!v->device) {
        free(v);
        return rl_fail(error, RL_ERR_UNAVAILABLE, "Embree refuses to start (error %d)",
                       (int)rtcGetDeviceError(NULL));
    }
    v->world = rtcNewScene(v->device);
    /* Robust: no ray slips between two triangles along their common edge. */
    rtcSetSceneFlags(v->world, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(v->world, RTC_BUILD_QUALITY_HIGH);
    int status = RL_OK;
    for (size_t i = 0; i < scene->n_objects && status == RL_OK; i++)
        if (!drawn || drawn[i])
            status = attach_mesh(v, &scene->object[i].mesh, (unsigned)i, error);
    if (status == RL_OK)
        rtcCommitScene(v->world);
    enum RTCError fault = rtcGetDeviceError(v->device);
    if (status == RL_OK && fault != RTC_ERROR_NONE)
        status = rl_fail(error, RL_ERR_SYSTEM, "Embree cannot take the scene (error %d)", (int)fault);
    if (status != RL_OK) {
        rl_visible_free(v);
        return status;
    }
    *out = v;
    return RL_OK;
}

void rl_visible_free(struct rl_visible *v)
{
    if (!v)
        return;
    rtcReleaseScene(v->world);
    rtcReleaseDevice(v->device);
    free(v);
}

static rl_vec3 vertex_vector(const float v[3])
{
    return v3(v[0], v[1], v[2]);
}

/* Mean of a triangle's corner values, weighted by the barycentric coordinates (1 - u - v, u, v). */
static rl_vec3 interpolate(float (*values)[3], const uint32_t corner[3], double u, double v)
{
    rl_vec3 sum = v3_scale(1.0 - u - v, vertex_vector(values[corner[0]]));
    sum = v3_madd(sum, u, vertex_vector(values[corner[1]]));
    return v3_madd(sum, v, vertex_vector(values[corner[2]]));
}

/* Where a ray meets a triangle's plane, and whether from behind. */
struct meeting {
    double t, u, v;
    bool from_behind;
};

/* In double precision (Moeller and Trumbore 1997): Embree's own u and v are floats, which moves a sharp highlight by more than the image's
 * last digit. */
static struct meeting meet_plane(const struct rl_mesh *mesh, size_t triangle, rl_vec3 origin,
                                 rl_vec3 direction)
{
    const uint32_t *corner = mesh->triangle[triangle];
    rl_vec3 first = vertex_vector(mesh->position[corner[0]]), from_first = v3_sub(origin, first);
    rl_vec3 a = v3_sub(vertex_vector(mesh->position[corner[1]]), first);
    rl_vec3 b = v3_sub(vertex_vector(mesh->position[corner[2]]), first);
    rl_vec3 p = v3_cross(direction, b), q = v3_cross(from_first, a);
    double scale = 1.0 / v3_dot(a, p);
    return (struct meeting){.t = v3_dot(b, q) * scale,
                            .u = v3_dot(from_first, p) * scale,
                            .v = v3_dot(direction, q) * scale,
                            .from_behind = v3_dot(direction, v3_cross(a, b)) > 0.0};
}

static void collect(struct point_context *context, const struct RTCHit *hit)
{
    const struct rl_mesh *mesh = &context->visible->scene->object[hit->geomID].mesh;
    double t = meet_plane(mesh, hit->primID, context->origin, context->direction).t;
    /* Of triangles that meet in an edge either will do: the one that the scene has first, in whatever order Embree gives them. */
    double slack = 1e-12 * context->t;
    bool before =
        hit->geomID != context->object ? hit->geomID < context->object : hit->primID < context->triangle;
    if (!(t < context->t - slack) && !(before && t <= context->t + slack))
        return;
    context->t = t;
    context->object = hit->geomID;
    context->triangle = hit->primID;
}

static struct RTCRayHit make_query(const struct rl_visible *visible, rl_vec3 direction, double near,
                                   double far)
{
    const rl_vec3 origin = visible->scene->camera.position;
    return (struct RTCRayHit){
        .ray = {.org_x = (float)origin.x,
                .org_y = (float)origin.y,
                .org_z = (float)origin.z,
                .dir_x = (float)direction.x,
                .dir_y = (float)direction.y,
                .dir_z = (float)direction.z,
                .tnear = (float)near,
                .tfar = (float)far,
                .mask = ~0u},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID},
    };
}

/* The triangle that the ray meets first: Embree's in single precision, and of those that single precision cannot tell from it the nearest in
 * double. */
static bool find_triangle(struct point_context *context, const struct rl_visible *visible, rl_vec3 direction)
{
    /* More than Embree's distances are off, relative to themselves. */
    const double unsure = 1e-6;
    const struct rl_camera *camera = &visible->scene->camera;
    const double along = v3_dot(direction, camera->forward);
    /* The planes of the GPU's camera lie at distances along `forward`. */
    const double near = camera->near_plane / along, far = camera->far_plane / along;
    *context = (struct point_context){.visible = visible, .origin = camera->position, .direction = direction};
    rtcInitIntersectContext(&context->embree);
    struct RTCRayHit query = make_query(visible, direction, near, far);
    rtcIntersect1(visible->world, &context->embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    context->object = query.hit.geomID;
    context->triangle = query.hit.primID;
    context->t = meet_plane(&visible->scene->object[context->object].mesh, context->triangle, context->origin,
                            context->direction)
                     .t;
    context->collects = true;
    double t = (double)query.ray.tfar;
    query = make_query(visible, direction, fmax(near, (1.0 - unsure) * t), fmin(far, (1.0 + unsure) * t));
    rtcIntersect1(visible->world, &context->embree, &query);
    return true;
}

bool rl_visible_point(struct rl_surface *surface, struct rl_visible_hit *hit,
                      const struct rl_visible *visible, rl_vec3 direction)
{
    struct point_context found;
    if (!find_triangle(&found, visible, direction))
        return false;
    const struct rl_mesh *mesh = &visible->scene->object[found.object].mesh;
    const uint32_t *corner = mesh->triangle[found.triangle];
    struct meeting m = meet_plane(mesh, found.triangle, found.origin, direction);
    surface->P = interpolate(mesh->position, corner, m.u, m.v);
    surface->N = v3_normalize(interpolate(mesh->normal, corner, m.u, m.v));
    if (m.from_behind)
        surface->N = v3_scale(-1.0, surface->N);
    surface->V = v3_normalize(v3_sub(found.origin, surface->P));
    *hit = (struct rl_visible_hit){.object = found.object,
                                   .triangle = found.triangle,
                                   .weight = {1.0 - m.u - m.v, m.u, m.v},
                                   .from_behind = m.from_behind};
    return true;
}
