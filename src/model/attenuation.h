/* Geometric attenuation of V-shaped grooves (Torrance and Sparrow 1967, in Blinn's 1977 form).
 *
 *     G = max(0, min(1, 2 (N.H)(N.V)/(V.H), 2 (N.H)(N.L)/(V.H))),  G = 0 when N.L <= 0
 *
 * The first term is masking (the facet is hidden from the eye), the second shadowing. Kimura and Tokoi print the masking
 * term with N.L in it, which would make it equal to the shadowing term; that is taken as a misprint.
 */
#ifndef RL_MODEL_ATTENUATION_H
#define RL_MODEL_ATTENUATION_H

#include <float.h>

/* Cosines in, G in [0, 1] out. V.H <= 0 means that the facet faces away from the eye: G = 0. */
static inline double rl_attenuation(double n_h, double n_v, double n_l, double v_h)
{
    if (!(n_l > 0.0) || !(v_h > 0.0) || !(n_h > 0.0) || !(n_v > 0.0))
        return 0.0;
    double least = n_v < n_l ? n_v : n_l;
    double larger = n_h > least ? n_h : least, smaller = n_h > least ? least : n_h;
    /* The larger factor is divided first: the product of both might be 0 or denormal where G is not. The quotient overflows only by a
     * denormal v_h, so that one is scaled. */
    if (v_h < DBL_MIN) {
        v_h *= 0x1p64;
        smaller *= 0x1p64;
    }
    double g = 2.0 * (larger / v_h) * smaller;
    return g < 1.0 ? g : 1.0;
}

#endif
