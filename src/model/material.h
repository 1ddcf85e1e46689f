/* What a surface is made of: plain data that scenes fill, effects and methods read. */
#ifndef RL_MODEL_MATERIAL_H
#define RL_MODEL_MATERIAL_H

#include <stdbool.h>

enum { RL_MATERIAL_EFFECTS_MAX = 24, RL_EFFECT_VALUES_MAX = 16 };

/* What is interpolated between the vertices of a triangle. `phong`: normals, and effects are evaluated for each pixel (Phong 1975).
 * `gouraud`: the effects' radiance, evaluated at the vertices (Gouraud 1971). `constant`: nothing, the effects are evaluated once a triangle, at
 * its centroid, for the normal of its plane: one shade a polygon, as Bouknight (1970) has it. */
enum rl_interpolation {
    RL_INTERPOLATION_PHONG,
    RL_INTERPOLATION_GOURAUD,
    RL_INTERPOLATION_CONSTANT,
    RL_INTERPOLATIONS
};

struct rl_material {
    char *name;
    double rr;          /* R_r of the ellipsoid distribution */
    double specular[3]; /* k_s, RGB factor on the highlight of shaped lights, >= 0 */
    const char *method; /* highlight method's name (static string), or NULL: no highlight */
    enum rl_interpolation
        interpolation; /* of effects; the highlight of shaped lights is always of a pixel's own normal */
    /* By the effect's row in rl_effects: whether the material names it, and its parameters' values in the order of the effect's
     * descriptor, a colour's three one after another (effects/effect.h has the functions to read and write them). */
    struct {
        bool given;
        double value[RL_EFFECT_VALUES_MAX];
    } effect[RL_MATERIAL_EFFECTS_MAX];
};

#endif
