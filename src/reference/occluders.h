/* What of a scene may hide its lights: the edges of every object, found once; and the view of them from one point.
 *
 * An object never hides a light from itself. Its normals are interpolated, its triangles flat: near the terminator a triangle's
 * own neighbours would cut off light that the shading normal says is there.
 *
 *     rl_occluders_make(&occluders, scene, rays, &error);
 *     struct rl_occluders_view view = {0};                       one a thread
 *     if (rl_occluders_see(&view, occluders, &surface, object, attenuation) == RL_OCCLUDERS_SOME)
 *         options.occlusion = &view.occlusion;
 *     rl_integrate_lines(...);
 *     rl_occluders_view_clear(&view);
 */
#ifndef RL_REFERENCE_OCCLUDERS_H
#define RL_REFERENCE_OCCLUDERS_H

#include "reference/occlusion.h"
#include "reference/shadow_rays.h"

struct rl_occluders;

struct rl_occluders_view {
    struct rl_occlusion occlusion;
    const struct rl_occluders *occluders;
    rl_vec3 P;
    size_t own;
    size_t light;    /* the only one that counts; RL_OCCLUDERS_LIGHTS: all do */
    uint32_t *found; /* scratch of a mesh */
    unsigned char *facing;
};

#define RL_OCCLUDERS_LIGHTS SIZE_MAX

enum rl_occluders_seen {
    RL_OCCLUDERS_NONE, /* nothing can stand between: proved by bounding spheres */
    RL_OCCLUDERS_SOME,
    RL_OCCLUDERS_NO_MEMORY
};

/* Both `scene` and `rays` must outlive it. */
int rl_occluders_make(struct rl_occluders **out, const struct rl_scene *scene,
                      const struct rl_shadow_rays *rays, struct rl_error *error);
void rl_occluders_free(struct rl_occluders *occluders);

/* From a point of object `own`; attenuation: nothing below the point's horizon counts. Keeps `occluders`. */
enum rl_occluders_seen rl_occluders_see(struct rl_occluders_view *view, const struct rl_occluders *occluders,
                                        const struct rl_surface *surface, size_t own, bool attenuation);
/* The same of what may hide one light, and nothing below the horizon. */
enum rl_occluders_seen rl_occluders_see_light(struct rl_occluders_view *view,
                                              const struct rl_occluders *occluders,
                                              const struct rl_surface *surface, size_t own, size_t light);
void rl_occluders_view_clear(struct rl_occluders_view *view);

#endif
