/* The steps of rl_plan_make, shared by the files that carry them out. */
#ifndef RL_SCENE_PLAN_BUILD_H
#define RL_SCENE_PLAN_BUILD_H

#include "scene/plan.h"

/* Programs a material can need: surface, sphere, highlight. */
enum { RL_PROGRAMS_PER_MATERIAL = 3 };

/* plan_passes.c: fills the material's programs and textures, adding to the plan what it does not have yet. */
void rl_plan_passes(struct rl_plan *plan, const struct rl_scene *scene, struct rl_plan_material *m);
int rl_plan_environment_program(struct rl_plan *plan);

/* plan_share.c: fills the objects' environment maps and the parts of meshes that they have in common. */
void rl_plan_share_environments(struct rl_plan *plan, const struct rl_scene *scene);
void rl_plan_share_meshes(struct rl_plan *plan, const struct rl_scene *scene);

/* plan_behind.c. A light as surfaces may have it behind them: what lies between its corners, all of them within a sphere (of a mesh light
 * with many vertices the corners of its box); a point, without corners; or a direction. */
struct rl_plan_body {
    rl_vec3 at; /* the sphere's centre, the point, the direction */
    double radius;
    bool parallel;
    size_t n_corners; /* 0: no more is known than the sphere */
    rl_vec3 corner[RL_POLYGON_VERTICES_MAX];
};

struct rl_plan_body rl_plan_body_of_light(const struct rl_light *light);
/* Whether all of the body is below the horizon everywhere on the object, with smooth normals. `centre`: the same as seen from the object's
 * centre, by an angle of this sine, for what is seen from there; negative: nothing is. */
bool rl_plan_behind(const struct rl_plan_body *body, const struct rl_object *object, double centre);
/* The same of triangles that are shaded as a whole: the normals of their planes are no means of those at their corners. */
bool rl_plan_behind_facets(const struct rl_plan_body *body, const struct rl_mesh *mesh);

/* plan_drop.c: leaves out what cannot matter. First the objects that the camera cannot see; then, when materials have their effects and
 * methods, the lights (plan->light, plan->source) that are behind every surface that is left, and the highlights of the objects that have
 * every shaped light behind them. */
void rl_plan_drop_objects(struct rl_plan *plan, const struct rl_scene *scene);
void rl_plan_drop_lights(struct rl_plan *plan, const struct rl_scene *scene);
/* The effect that makes the material's highlight black, a factor with coefficients of 0; NULL if there is none. */
const struct rl_effect *rl_plan_zero_factor(const struct rl_material *material);
bool rl_plan_dark(const double strength[3]);

/* plan_reasons.c. Why nothing could be hidden from anything, if shadows were on; or RL_WHY_NONE, which is 0. */
enum rl_plan_reason rl_plan_no_shadows(const struct rl_plan *plan, const struct rl_scene *scene);
/* Rows of plan->drop: whatever is in the scene and not in the finished plan, and why. */
int rl_plan_list_drops(struct rl_plan *plan, const struct rl_scene *scene, struct rl_error *error);

#endif
