/* Within the study `interpolation`: plan and tables (interpolation.c), the scenes (interpolation_scene.c), points of the exact surface and
 * where meshes have them (interpolation_surface.c), radiance of both (interpolation_case.c), measuring (interpolation_error.c,
 * interpolation_bands.c, times in interpolation_measure.c), rates (interpolation_rates.c) and claims (interpolation_claims.c).
 */
#ifndef RL_STUDIES_INTERPOLATION_H
#define RL_STUDIES_INTERPOLATION_H

#include "effects/effect.h"
#include "measure/statistics.h"
#include "reference/interpolated.h"
#include "scene/plan.h"
#include "scene/scene.h"
#include "studies/study.h"

/* Three kinds of cases, without a scene: the study makes its own, of one object in one light.
 *
 *     series=error object=O light=L tessellation=T interpolation=I
 *                          rmse, max: radiance at the points of the exact surface that the pixels of a picture show, by the mesh against
 *                          the surface itself, both in double precision on the CPU; triangles; points. All of an object and light are
 *                          one group
 *     series=bands object=O surface=S tessellation=T interpolation=I
 *                          along one line of the picture, whose length is 1: slope, the largest slope of radiance; jump, the largest
 *                          change of slope from one triangle to the next, both of the mesh whatever the pixels are; step, the largest
 *                          difference of two neighbouring pixels; bend, the largest change of slope from one pixel to the next. Series
 *                          radiance and bend. surface=exact: the surface itself
 *     series=time object=O tessellation=T interpolation=I arm=A
 *                          frame_ms and the like (timing_arms.h), time_to_phong. arm=again: phong once more
 */
int rl_interpolation_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                             const struct rl_scene *scene, struct rl_error *error);

int rl_interpolation_measure_errors(struct rl_record *records, size_t n, struct rl_bench *bench,
                                    struct rl_error *error);
int rl_interpolation_measure_bands(struct rl_record *record, struct rl_bench *bench, struct rl_error *error);

/* Records of what follows from many errors, one for each object, light and interpolation: rate, of the RMSE in h = 1/tessellation, from
 * the finest RL_INTERPOLATION_FITTED tessellations, with Student's interval; fitted, how many there were; from_tessellation; and
 * triangles_for_step, the triangles for an RMSE of 1/255: between those of the last tessellation above and of the first below it; where
 * the coarsest is below already NAN, from 0 to its triangles. */
enum { RL_INTERPOLATION_FITTED = 5 };
int rl_interpolation_derive(struct rl_run *derived, const struct rl_run *run, struct rl_error *error);

/* The same for one, as metrics; NAN where there are too few cases. Reads the cases. */
struct rl_interpolation_rates {
    struct rl_interval rate, triangles;
    double from_tessellation;
    size_t points; /* tessellations fitted */
};
struct rl_interpolation_rates rl_interpolation_rates(const struct rl_run *run, const char *object,
                                                     const char *light, const char *interpolation);

int rl_interpolation_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error);

/* ---- The scenes ---- */

/* `object` (sphere, teapot) of that tessellation in `light` (eye: a point light where the eye is; side: a parallel one from the right
 * and above, so that the terminator is in view), `diffuse` and `phong` of that exponent, at most 1 bright. Clear with
 * rl_interpolation_scene_free. */
int rl_interpolation_scene_make(struct rl_scene *scene, const char *object, int tessellation,
                                const char *light, double exponent, struct rl_error *error);
void rl_interpolation_scene_free(struct rl_scene *scene);

/* ---- The exact surface ---- */

/* A point of the sphere or of a patch of the teapot. */
struct rl_exact_point {
    rl_vec3 P, N;
    int patch; /* of the teapot */
    double u, v;
};

/* Where a mesh has it: on the sphere the triangle that the ray from the centre meets, on the teapot the point of the same u and v. */
struct rl_mesh_point {
    size_t triangle;
    double weight[3]; /* of its corners; they sum to 1 */
};

/* The point at these weights of a triangle's corners, brought to the exact surface. */
void rl_exact_from_mesh(struct rl_exact_point *point, const char *object, const struct rl_mesh *mesh,
                        int tessellation, const struct rl_mesh_point *at);

/* Finds points on a mesh of `object`, whatever its tessellation. */
struct rl_mesh_locator;
int rl_mesh_locator_make(struct rl_mesh_locator **locator, const char *object, const struct rl_mesh *mesh,
                         int tessellation, struct rl_error *error);
void rl_mesh_locator_free(struct rl_mesh_locator *locator);
struct rl_mesh_point rl_mesh_locate(const struct rl_mesh_locator *locator,
                                    const struct rl_exact_point *point);

/* ---- Radiance ---- */

/* A case's scene of some tessellation, with what it takes to evaluate its effects. */
struct rl_interpolation_case {
    char object[RL_NAME_MAX];
    int tessellation;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_lights lights;
    double params[RL_PLAN_EFFECTS_MAX][RL_EFFECT_PARAMS][4];
    struct rl_interpolated interpolated;
};

/* The scene that `parameters` name, but of that tessellation. On an error there is nothing to clear. */
int rl_interpolation_case_make(struct rl_interpolation_case *c, const char *parameters, int tessellation,
                               int threads, struct rl_error *error);
void rl_interpolation_case_clear(struct rl_interpolation_case *c);

/* Towards the eye, from a point with this normal; and from a point of the mesh, interpolated as the case has it. */
double rl_interpolation_radiance(struct rl_interpolation_case *c, rl_vec3 P, rl_vec3 N);
double rl_interpolation_mesh_radiance(struct rl_interpolation_case *c, const struct rl_mesh_point *at);

#endif
