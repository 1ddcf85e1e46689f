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

/* Rejects hits on back faces, so that the ray goes on through them as the rasteriser does. Embree's geometric normal is
 * (v1 - v0) x (v2 - v0). */
static void cull_back_face(const struct RTCFilterFunctionNArguments *a)
{
    const struct RTCRay *ray = (const struct RTCRay *)a->ray;
    const struct RTCHit *hit = (const struct RTCHit *)a->hit;
    float facing = ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z;
    if (!(facing < 0.0f))
        a->valid[0] = 0;
}

/* A ray of rl_visible_hidden: RTCIntersectContext must come first. */
struct hidden_context {
    struct RTCIntersectContext embree;
    unsigned own;
};

static void skip_own(const struct RTCFilterFunctionNArguments *a)
{
    const struct hidden_context *context = (const struct hidden_context *)a->context;
    if (((const struct RTCHit *)a->hit)->geomID == context->own)
        a->valid[0] = 0;
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
        if (v->culling)
            rtcSetGeometryIntersectFilterFunction(geometry, cull_back_face);
        rtcSetGeometryOccludedFilterFunction(geometry, skip_own);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(v->world, geometry, id);
    }
    rtcReleaseGeometry(geometry);
    if (!positions || !indices)
        return rl_fail_memory(error, "Embree's copy of a mesh");
    return RL_OK;
}

int rl_visible_make(struct rl_visible **out, const struct rl_scene *scene, bool culling,
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

/* Where the ray meets the triangle's plane, and whether from behind, in double precision (Moeller and Trumbore 1997): Embree's own u and v are floats, which
 * moves a sharp highlight by more than the image's last digit. */
static bool meet_plane(double *u, double *v, const struct rl_mesh *mesh, const uint32_t corner[3],
                       rl_vec3 origin, rl_vec3 direction)
{
    rl_vec3 first = vertex_vector(mesh->position[corner[0]]), from_first = v3_sub(origin, first);
    rl_vec3 a = v3_sub(vertex_vector(mesh->position[corner[1]]), first);
    rl_vec3 b = v3_sub(vertex_vector(mesh->position[corner[2]]), first);
    rl_vec3 p = v3_cross(direction, b);
    double scale = 1.0 / v3_dot(a, p);
    *u = v3_dot(from_first, p) * scale;
    *v = v3_dot(direction, v3_cross(from_first, a)) * scale;
    return v3_dot(direction, v3_cross(a, b)) > 0.0;
}

bool rl_visible_point(struct rl_surface *surface, size_t *object, const struct rl_visible *visible,
                      rl_vec3 direction)
{
    const struct rl_camera *camera = &visible->scene->camera;
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit query = {
        .ray = {.org_x = (float)camera->position.x,
                .org_y = (float)camera->position.y,
                .org_z = (float)camera->position.z,
                .dir_x = (float)direction.x,
                .dir_y = (float)direction.y,
                .dir_z = (float)direction.z,
                /* The planes of the GPU's camera lie at distances along `forward`. */
                .tnear = (float)(camera->near_plane / v3_dot(direction, camera->forward)),
                .tfar = (float)(camera->far_plane / v3_dot(direction, camera->forward)),
                .mask = ~0u},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID},
    };
    rtcIntersect1(visible->world, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return false;
    const struct rl_mesh *mesh = &visible->scene->object[query.hit.geomID].mesh;
    const uint32_t *corner = mesh->triangle[query.hit.primID];
    double u, v;
    bool from_behind = meet_plane(&u, &v, mesh, corner, camera->position, direction);
    surface->P = interpolate(mesh->position, corner, u, v);
    surface->N = v3_normalize(interpolate(mesh->normal, corner, u, v));
    if (from_behind)
        surface->N = v3_scale(-1.0, surface->N);
    surface->V = v3_normalize(v3_sub(camera->position, surface->P));
    *object = query.hit.geomID;
    return true;
}

bool rl_visible_hidden(const struct rl_visible *visible, size_t own, rl_vec3 P, rl_vec3 L, double distance)
{
    /* Short of the light by more than rounding to float may add. */
    const double before = 1.0 - 1e-6;
    struct hidden_context context = {.own = (unsigned)own};
    rtcInitIntersectContext(&context.embree);
    struct RTCRay ray = {.org_x = (float)P.x,
                         .org_y = (float)P.y,
                         .org_z = (float)P.z,
                         .dir_x = (float)L.x,
                         .dir_y = (float)L.y,
                         .dir_z = (float)L.z,
                         .tfar = (float)(before * distance),
                         .mask = ~0u};
    rtcOccluded1(visible->world, &context.embree, &ray);
    return ray.tfar < 0.0f;
}
