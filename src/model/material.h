/* What a surface is made of: plain data that scenes fill, effects and methods read. */
#ifndef RL_MODEL_MATERIAL_H
#define RL_MODEL_MATERIAL_H

struct rl_material {
    char *name;
    double rr;          /* R_r of the ellipsoid distribution */
    double ambient[3];  /* k_a times the surface's colour, RGB, >= 0 */
    double diffuse[3];  /* k_d, RGB reflectance in [0, 1] */
    double specular[3]; /* k_s, RGB factor on the highlight, >= 0 */
    const char *method; /* highlight method's name (static string), or NULL: no highlight */
};

#endif
