/* The bounding spheres' margin in closed form: `margin auto`.
 *
 * A pixel whose mirror direction R misses every light's sphere, of radius (1 + m) x the light's bounding radius r, is left
 * without highlight. The margin below keeps what such a pixel loses at or under `loss` times the brightest light's radiance:
 * L_o itself for a method that integrates, and for random normals the mean over the random numbers.
 *
 * Why. Let u be the unit direction to the middle of a light's bounding sphere, at the distance d from where the light is seen,
 * and a the angular radius of all that can shine there,
 *
 *     a = asin(r/d) + f + 2 e.
 *
 * f is how far the environment map carries a texel's middle, which saw the light, half of a texel's diagonal (the nearest
 * texel is read, and the face is 2 wide at the distance 1): sqrt(2)/env_size. e is how far the normal
 * map's rounding may turn a normal, asin(sqrt(3) x the largest rounding of a component); L turns by twice that, and instead
 * of turning L the light is taken as larger. Let the angle from R to u be more than a + b.
 *
 * (1) L is R turned by 2 delta about an axis b, L = rotation of R, so the angle from R to L is at most 2 |delta|. Where L meets
 * the light, |delta| > b/2: at most 2 (1 - U(b/2)) of each line's weight, and as (1/pi) of the integral over theta is a mean, of
 * the pixel's. G <= 1 only lessens it.
 *
 * (2) Half of that, if the light keeps to one side of the line. L runs round the circle L.b = -v_b, of radius s =
 * sqrt(1 - v_b^2), through the plane angle 2 delta; L.N > 0 is one half of it, with delta = 0 inside. The light's cap L.u >= cos a
 * cuts an arc out of the circle. It meets the upper half on both sides of delta = 0 without holding it only if it holds all
 * of the lower half, hence more than half of the circle, hence the circle's middle: -v_b u_b > cos a. Then |v_b| and |u_b| are
 * more than cos a; s, and likewise the part of u across b, less than sin a; and R.u >= -v_b u_b - sin^2 a > cos a - sin^2 a.
 * But R.u < cos(a + b). So there is but one side where cos(a + b) <= cos a - sin^2 a, that is, b >= b_1(a) =
 * acos(cos a - sin^2 a) - a (about 0.73 a), and then 1 - U(b/2) is the loss. Several lights may lie on different sides.
 *
 *     one light:       b = min(2 delta(1 - loss/2), max(2 delta(1 - loss), b_1(a)))         delta(U): the inverse cdf
 *     several lights:  b = 2 delta(1 - loss/2)
 *
 * (3) Methods that read an environment map see the lights from the object's centre, and the sphere pass asks from there too (a
 * test from P would cut away what the map shows elsewhere): d is the distance from the centre. The sphere of radius d sin(a + b)
 * has the angular radius a + b. If a + b reaches a right angle no sphere is worth its pass: INFINITY.
 *
 * (4) Without a map the lights are seen from P, f = 0, and d varies. With b = 2 delta(1 - loss/2) for all, the radius that is
 * needed, d sin(asin(r/d) + b) = r cos b + sqrt(d^2 - r^2) sin b, grows with d: the object's farthest point decides. A point so
 * near that its angle passes a right one, d < r/cos b, lies within the sphere: r cos b + sqrt(d'^2 - r^2) sin b > r/cos b for any
 * d' > r/cos b.  (e > 0: r stands for d sin(asin(r/d) + 2 e) of the farthest point, which is no less than nearer ones need.)
 *
 * (5) Energy. What all the pixels skipped lose together is at most loss x radiance x their number. No bound relative to the
 * highlight's whole energy follows: a camera that sees the lobe's tail alone may lose all of it, however little that is.
 *
 * All sizes of one margin are multiples of each light's own radius, so the largest one needed serves all. The printed tangent
 * frame only narrows the lobe along each line and loses less. A fixed pattern (regular) has its own sum in place of the
 * integral, which the bound is not about.
 */
#ifndef RL_SCENE_MARGIN_H
#define RL_SCENE_MARGIN_H

#include "scene/plan.h"

/* The margin m >= 0 for the objects of one material, 0 < loss < 1, or INFINITY: no sphere. Of the settings normal_bits and
 * env_size count. */
double rl_margin_auto(const struct rl_scene *scene, const struct rl_plan_material *material,
                      const struct rl_settings *settings, double loss);

#endif
