/* Geometric attenuation of V-shaped grooves (Torrance and Sparrow 1967, in Blinn's 1977 form).
 *
 *     G = max(0, min(1, 2 (N.H)(N.V)/(V.H), 2 (N.H)(N.L)/(V.H))),  G = 0 when N.L <= 0
 *
 * The first term is masking (the facet is hidden from the eye), the second shadowing. Kimura and Tokoi print the masking
 * term with N.L in it, which would make it equal to the shadowing term; that is taken as a misprint.
 */
#ifndef RL_MODEL_ATTENUATION_H
#define RL_MODEL_ATTENUATION_H

/* Cosines in, G in [0, 1] out. V.H <= 0 means that the facet faces away from the eye: G = 0. */
static inline double rl_attenuation(double n_h, double n_v, double n_l, double v_h)
{
    if (!(n_l > 0.0) || !(v_h > 0.0) || !(n_h > 0.0) || !(n_v > 0.0))
        return 0.0;
    double least = n_v < n_l ? n_v : n_l;
    /* Compared before it is divided: v_h may be tiny, and the quotient may overflow. */
    double numerator = 2.0 * n_h * least;
    return numerator >= v_h ? 1.0 : numerator / v_h;
}

#endif
