/* Rays against the scene's triangles, in double precision (see shadow_rays.h). */
#include "reference/shadow_rays.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <stdlib.h>

/* One object, as its geometry's callbacks get it. */
struct caster {
    const struct rl_mesh *mesh;
    size_t object;
    float pad; /* by which a triangle's box is wider, on each side */
};

struct rl_shadow_rays {
    RTCDevice device;
    RTCScene world;
    struct caster *caster;
};

/* RTCIntersectContext must come first. */
struct context {
    struct RTCIntersectContext embree;
    rl_vec3 P, L;
    double size, distance; /* of P from the origin; of the light from P */
    size_t own;
};

static rl_vec3 corner(const struct rl_mesh *mesh, size_t triangle, int i)
{
    const float *p = mesh->position[mesh->triangle[triangle][i]];
    return v3(p[0], p[1], p[2]);
}

static void find_bounds(const struct RTCBoundsFunctionArguments *a)
{
    const struct caster *caster = a->geometryUserPtr;
    rl_vec3 first = corner(caster->mesh, a->primID, 0), low = first, high = first;
    for (int i = 1; i < 3; i++) {
        rl_vec3 p = corner(caster->mesh, a->primID, i);
        low = v3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = v3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    *a->bounds_o = (struct RTCBounds){
        .lower_x = (float)low.x - caster->pad,
        .lower_y = (float)low.y - caster->pad,
        .lower_z = (float)low.z - caster->pad,
        .upper_x = (float)high.x + caster->pad,
        .upper_y = (float)high.y + caster->pad,
        .upper_z = (float)high.z + caster->pad,
    };
}

/* L passes the triangle where it is on one side of all three edges, b x a being exactly -(a x b). On an edge counts: as both
 * neighbours'. Seen edge-on a triangle hides nothing. */
static bool meets(const struct context *ray, const struct rl_mesh *mesh, size_t triangle)
{
    /* Short of the light by more than rounding to float may add; and as much off P's own plane. */
    static const double before = 1.0 - 1e-6, touch = 0x1p-22;
    rl_vec3 c[3];
    double side[3], size = ray->size;
    for (int i = 0; i < 3; i++) {
        rl_vec3 p = corner(mesh, triangle, i);
        size = fmax(size, v3_length(p));
        c[i] = v3_sub(p, ray->P);
    }
    for (int i = 0; i < 3; i++)
        side[i] = v3_dot(ray->L, v3_cross(c[i], c[(i + 1) % 3]));
    bool left = side[0] >= 0.0 && side[1] >= 0.0 && side[2] >= 0.0,
         right = side[0] <= 0.0 && side[1] <= 0.0 && side[2] <= 0.0;
    if (left == right)
        return false;
    rl_vec3 normal = v3_cross(v3_sub(c[1], c[0]), v3_sub(c[2], c[0]));
    double height = v3_dot(normal, c[0]);
    if (!(fabs(height) > touch * size * v3_length(normal)))
        return false;
    double t = height / v3_dot(normal, ray->L);
    return t > 0.0 && t < before * ray->distance;
}

/* Rays come one at a time. */
static void occlude(const struct RTCOccludedFunctionNArguments *a)
{
    const struct caster *caster = a->geometryUserPtr;
    const struct context *ray = (const struct context *)a->context;
    if (a->valid[0] && caster->object != ray->own && meets(ray, caster->mesh, a->primID))
        ((struct RTCRay *)a->ray)->tfar = -INFINITY;
}

/* Boxes as callbacks have no other geometry than these. */
static void attach(struct rl_shadow_rays *rays, struct caster *caster)
{
    RTCGeometry geometry = rtcNewGeometry(rays->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, (unsigned)caster->mesh->n_triangles);
    rtcSetGeometryUserData(geometry, caster);
    rtcSetGeometryBoundsFunction(geometry, find_bounds, NULL);
    rtcSetGeometryOccludedFunction(geometry, occlude);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(rays->world, geometry);
    rtcReleaseGeometry(geometry);
}

/* The largest coordinate of any vertex. */
static double extent(const struct rl_scene *scene)
{
    double most = 0.0;
    for (size_t i = 0; i < scene->n_objects; i++)
        for (size_t k = 0; k < scene->object[i].mesh.n_vertices; k++)
            for (int j = 0; j < 3; j++)
                most = fmax(most, fabs((double)scene->object[i].mesh.position[k][j]));
    return most;
}

int rl_shadow_rays_make(struct rl_shadow_rays **out, const struct rl_scene *scene, struct rl_error *error)
{
    struct rl_shadow_rays *rays = calloc(1, sizeof *rays);
    *out = NULL;
    if (rays)
        rays->caster = calloc(scene->n_objects + 1, sizeof *rays->caster);
    if (!rays || !rays->caster) {
        free(rays);
        return rl_fail_memory(error, "the shadows");
    }
    rays->device = rtcNewDevice("verbose=0");
    if (!rays->device) {
        rl_shadow_rays_free(rays);
        return rl_fail(error, RL_ERR_UNAVAILABLE, "Embree refuses to start (error %d)",
                       (int)rtcGetDeviceError(NULL));
    }
    rays->world = rtcNewScene(rays->device);
    rtcSetSceneFlags(rays->world, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(rays->world, RTC_BUILD_QUALITY_HIGH);
    /* P and L rounded to float, and the way along L: some units in the last place each. */
    float pad = (float)(0x1p-20 * extent(scene));
    for (size_t i = 0; i < scene->n_objects; i++) {
        rays->caster[i] = (struct caster){&scene->object[i].mesh, i, pad};
        attach(rays, &rays->caster[i]);
    }
    rtcCommitScene(rays->world);
    enum RTCError fault = rtcGetDeviceError(rays->device);
    if (fault != RTC_ERROR_NONE) {
        rl_shadow_rays_free(rays);
        return rl_fail(error, RL_ERR_SYSTEM, "Embree cannot take the scene (error %d)", (int)fault);
    }
    *out = rays;
    return RL_OK;
}

void rl_shadow_rays_free(struct rl_shadow_rays *rays)
{
    if (!rays)
        return;
    if (rays->world)
        rtcReleaseScene(rays->world);
    if (rays->device)
        rtcReleaseDevice(rays->device);
    free(rays->caster);
    free(rays);
}

bool rl_shadow_rays_hidden(const struct rl_shadow_rays *rays, size_t own, rl_vec3 P, rl_vec3 L,
                           double distance)
{
    struct context context = {.P = P, .L = L, .size = v3_length(P), .distance = distance, .own = own};
    rtcInitIntersectContext(&context.embree);
    struct RTCRay ray = {.org_x = (float)P.x,
                         .org_y = (float)P.y,
                         .org_z = (float)P.z,
                         .dir_x = (float)L.x,
                         .dir_y = (float)L.y,
                         .dir_z = (float)L.z,
                         .tfar = (float)distance,
                         .mask = ~0u};
    rtcOccluded1(rays->world, &context.embree, &ray);
    return ray.tfar < 0.0f;
}
