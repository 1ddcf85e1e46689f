/* Within the study `fur`: plan and tables (fur.c), what is shaded (fur_scene.c), the models' terms (fur_terms.c), pictures against closed forms
 * (fur_profile.c), the contact sheet (fur_sheet.c), vertices against pixels, monochrome and times (fur_measure.c), claims (fur_claims.c,
 * fur_cost_claims.c). The listing is the vertex shader that kajiya-printed and goldman-printed are (src/effects/). */
#ifndef RL_STUDIES_FUR_H
#define RL_STUDIES_FUR_H

#include "studies/judging.h"
#include "studies/study.h"

/* Without a scene the study makes its own: a ball seen from far away in one parallel light that comes from `beta` degrees above the eye, 0
 * being from behind the eye and 180 from behind the ball. With one, all that its objects wear is the fur; there is no beta and no
 * tessellation.
 *
 *     series=terms points=N           no picture. wrong, right: how far cos cos - sin sin and cos cos + sin sin are from cos(psi - theta) at
 *                                     most; direction: how far the effect goldman with c is from that with both rho; inputs, undefined_listing,
 *                                     undefined: N parallel to l or e or both, and for how many of these kappa is no number
 *     series=form beta=B sines=S sign=K
 *                                     the highlight without k_s, for N in the plane of light and eye: sines = plus (right) or minus (as
 *                                     listed), the cosine's sign = kept or lost (as listed). middle, rim (the brighter end), least; with line=on
 *                                     series lobe, by degrees of N from -90, below the eye, to 90
 *     series=profile beta=B effect=E  middle column of a picture. middle (where N points at the eye), rim, least, off: how far it is from the
 *                                     closed form at most, but for Goldman's within a degree of
 *                                     its steps; it is the interval of the first two. With line=on series profile, in pairs:
 *                                     degrees between N and eye, radiance. All of it is the red channel
 *     series=panel effect=E           series pixels: two a value, of the upper half in its last 24 bits and as far down in the
 *                                     lower half above these, each 8 bits of red, green, blue (sRGB); exposure, which all of a sheet
 *                                     share; clipped, negative: shares of the foreground above 1 and below 0
 *     series=vertex effect=E tessellation=T
 *                                     the picture evaluated at vertices against that at pixels, same mesh: rmse, max, triangles
 *     series=mono effect=E            the picture in shades of grey against that in colour: rmse, max
 *     series=time effect=E interpolation=I monochrome=M arm=A tessellation=T
 *                                     those of timing_arms.h; draws, triangles; time_to_pixel: over the same effect per pixel in colour. arm=again:
 *                                     kajiya per pixel once more
 */
int rl_fur_measure(struct rl_record *records, size_t n, struct rl_bench *bench, const struct rl_scene *scene,
                   struct rl_error *error);
int rl_fur_measure_terms(struct rl_record *record, struct rl_error *error);
int rl_fur_measure_form(struct rl_record *record, struct rl_error *error);
int rl_fur_measure_profile(struct rl_record *record, struct rl_bench *bench, struct rl_error *error);
int rl_fur_measure_sheet(struct rl_record *records, size_t n, struct rl_bench *bench,
                         const struct rl_scene *scene, struct rl_error *error);

int rl_fur_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);
int rl_fur_judge_costs(const struct rl_judging *j);

/* ---- What is shaded ---- */

/* The five models of fur, by their effects' names; NULL at the end. */
extern const char *const rl_fur_models[];

/* Of the ball's red channel: irradiance, coefficients, and Goldman's c. */
#define RL_FUR_IRRADIANCE 2.0
#define RL_FUR_DIFFUSE 0.1
#define RL_FUR_SPECULAR 0.15
#define RL_FUR_C 0.5

/* The study's own ball, or a view of a scene, that wears what a case's parameters say: effect = a model of fur, lambert, phong (Lambert's and a
 * highlight of cos^4) or none (ambient light alone), with exponent and monochrome. */
struct rl_fur_scene {
    struct rl_scene scene;
    bool own;
};

/* `from` NULL: the ball. Clear it, also after an error; `from` must outlive it. */
int rl_fur_scene_make(struct rl_fur_scene *s, const struct rl_scene *from, const char *parameters,
                      struct rl_error *error);
void rl_fur_scene_clear(struct rl_fur_scene *s);

/* One picture, of the case's parameters but for what `more` says. */
int rl_fur_picture(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *from,
                   const char *parameters, const char *more, struct rl_error *error);

/* Towards the ball's light. */
rl_vec3 rl_fur_light(double beta_degrees);

/* The ball's radiance in closed form, N, e and l being in one plane at these angles (radians) from some direction of it, by nothing but
 * their sums and differences; NAN for an effect that is no fur. */
double rl_fur_closed(const char *effect, double exponent, double n, double e, double l);

#endif
