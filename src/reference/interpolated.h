/* Shading that is interpolated on the CPU: the effects' radiance at every vertex of a mesh (Gouraud 1971), or one for each of its triangles
 * (constant: at its centroid, for the normal of its plane), in double precision. What the shaders gouraud_vertex and constant_vertex do.
 */
#ifndef RL_REFERENCE_INTERPOLATED_H
#define RL_REFERENCE_INTERPOLATED_H

#include <stddef.h>

#include "base/error.h"
#include "effects/effect.h"
#include "model/material.h"
#include "reference/shadows.h"
#include "scene/mesh.h"

/* What is evaluated, seen from `eye`. */
struct rl_interpolated_shading {
    const struct rl_effect *const *effect;
    size_t n_effects;
    double (*params)[RL_EFFECT_PARAMS][4]; /* what effect i packed */
    const struct rl_lights *lights;
    rl_vec3 eye;
    bool both_sides;                  /* back faces are seen, too: shaded with -N */
    const struct rl_shadows *shadows; /* NULL: nothing hides the lights */
    struct rl_shadows_view *view;     /* with shadows: one a thread */
    size_t object;                    /* with shadows: whose mesh it is */
};

struct rl_interpolated {
    const struct rl_mesh *mesh;
    enum rl_interpolation interpolation;
    double (*radiance)[3]; /* RGB of each vertex, or `constant`: of each triangle */
    double (*behind)[3];   /* the same from behind; NULL: that is not seen */
    double error[3];       /* how far off any of them may be, by what is known of the lights' visibility */
};

/* Evaluates all of the mesh, which must outlive the result; of `phong` nothing, for nothing of the kind is asked of it. */
int rl_interpolated_make(struct rl_interpolated *interpolated, const struct rl_mesh *mesh,
                         enum rl_interpolation interpolation, const struct rl_interpolated_shading *shading,
                         int threads, struct rl_error *error);
void rl_interpolated_clear(struct rl_interpolated *interpolated);

/* At the point of the triangle with these weights of its corners, seen from its front or from behind. */
void rl_interpolated_at(double rgb[3], const struct rl_interpolated *interpolated, size_t triangle,
                        const double weight[3], bool from_behind);

#endif
