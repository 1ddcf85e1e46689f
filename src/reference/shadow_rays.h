/* Whether something of a scene stands between a point and a light, decided in double precision.
 *
 * Embree finds the triangles whose boxes a ray passes near to; whether it meets one is decided here, by the signs of three triple
 * products (Segura and Feito 2001), which two triangles have in common along their common edge: no ray slips through between them. The
 * boxes are wider than the triangles by more than rounding to float moves a ray, so that none that is met is missed.
 *
 * What a ray meets at its very ends does not hide anything:
 *   - of the object that the point is of no triangle counts. Its normals are interpolated, its triangles flat: near the terminator
 *     the point's neighbours would cut off light that the shading normal says is there;
 *   - nor does a triangle of another object in whose plane the point lies, up to what rounding vertices to float may do to that plane
 *     (2^-22 of the coordinates): two coplanar sheets do not shade one another;
 *   - nor does what lies as far away as the light, up to 1e-6 of the distance: a lamp that touches a wall shines.
 *
 *     rl_shadow_rays_make(&rays, scene, &error);
 *     if (rl_shadow_rays_hidden(rays, object, P, L, distance)) ...               INFINITY: parallel light
 *     rl_shadow_rays_free(rays);
 */
#ifndef RL_REFERENCE_SHADOW_RAYS_H
#define RL_REFERENCE_SHADOW_RAYS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "scene/scene.h"

struct rl_shadow_rays;

/* Of every object, seen by the camera or not. `scene` must outlive it. */
int rl_shadow_rays_make(struct rl_shadow_rays **out, const struct rl_scene *scene, struct rl_error *error);
void rl_shadow_rays_free(struct rl_shadow_rays *rays);

/* Whether any object but `own` meets the ray from P in direction L (unit) nearer than this distance, from either side. P is no
 * further from the origin than some vertex of the scene, or not by much. May be called by several threads at once. */
bool rl_shadow_rays_hidden(const struct rl_shadow_rays *rays, size_t own, rl_vec3 P, rl_vec3 L,
                           double distance);

#endif
