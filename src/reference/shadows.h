/* What hides the lights from effects (struct rl_visibility): a shadow ray each to point and parallel lights and to the centroids of
 * shaped ones (shadow_rays.h), and of a polygon the share of its irradiance that arrives.
 *
 * That share is the irradiance of what is left of the polygon over that of all of it, which is Lambert's edge sum (the effect
 * diffuse-area). What is left is integrated along meridians about N: each is a line with V = N, cut at the polygon's and the occluders'
 * edges in closed form (occlusion.h), one ray deciding for each part, of which half the difference of its ends' squared sines is the
 * integral; adaptively over the azimuth, split where that breaks, to an absolute error of the settings' tolerance in E/pi for a radiance of 1.
 * Lights do not hide one another from effects, with shadows or without.
 *
 *     rl_shadows_make(&shadows, scene, rays, occluders, &lights, tolerance, &error);
 *     struct rl_shadows_view view = {0};                                          one a thread
 *     lights.visibility = rl_shadows_see(&view, shadows, object);                 for points of this object
 *     rl_effects_shade(..., &lights, rgb);
 *     rl_shadows_view_clear(&view);
 */
#ifndef RL_REFERENCE_SHADOWS_H
#define RL_REFERENCE_SHADOWS_H

#include "effects/effect.h"
#include "reference/occluders.h"
#include "reference/shadow_rays.h"

struct rl_shadows;

struct rl_shadows_view {
    struct rl_visibility visibility;
    const struct rl_shadows *shadows;
    struct rl_occluders_view occluders;
    size_t own;
    /* Whether something may hide this light from this place: what the last call found, for a light's polygons come one by one. */
    struct rl_surface seen_from;
    size_t seen_light;
    enum rl_occluders_seen seen;
};

/* All but `error` must outlive it. lights: all of the scene's shaped lights, or those of the indices `index`, as
 * rl_scene_lights_make and rl_plan_lights_make give them. tolerance: 0 to 1. */
int rl_shadows_make(struct rl_shadows **out, const struct rl_scene *scene, const struct rl_shadow_rays *rays,
                    const struct rl_occluders *occluders, const struct rl_lights *lights, const size_t *index,
                    double tolerance, struct rl_error *error);
void rl_shadows_free(struct rl_shadows *shadows);

/* For points of object `own`, which never hides a light from itself. The result lives in the view, which belongs to one thread. */
const struct rl_visibility *rl_shadows_see(struct rl_shadows_view *view, const struct rl_shadows *shadows,
                                           size_t own);
void rl_shadows_view_clear(struct rl_shadows_view *view);

#endif
