/* Terms of fur models: fibres along n, unit vectors l to the light and e to the eye, no surface but the fibres.
 *
 *     |n x l|                                          a fibre's share of light from l, seen from the side
 *     (l.n)(-n.e) + |n x l||n x e| = cos(psi - theta)  Kajiya and Kay 1989: light is mirrored into the cone about n of half angle psi,
 *                                                      psi between n and l; theta is between n and -e; 1 where e lies on the cone
 *     (l.n)(-n.e) - |n x l||n x e| = cos(psi + theta)  as a widely copied listing has it, a wrong sign
 *     kappa = (n x l).(n x e)/(|n x l||n x e|)         Goldman 1997: cosine of the angle about n between light and eye
 *
 * The sines are lengths of cross products and so accurate near 0. kappa is 0/0 where n is parallel to l or e: no angle is meant there.
 * Here it goes to 0, the mean over all angles, by both sines counting for RL_FUR_PARALLEL at least: continuous, and as it was but for
 * directions less than 0.006 degrees from parallel. */
#ifndef RL_MODEL_FUR_H
#define RL_MODEL_FUR_H

#include "model/half.h"
#include "model/pair.h"

#define RL_FUR_PARALLEL 1e-4

static inline double rl_fur_sine(rl_vec3 n, rl_vec3 a)
{
    return v3_length(v3_cross(n, a));
}

/* Sines and cosines of n to l and e, as those of the directions: what lengths are off by 1 is divided away. */
struct rl_fur_terms {
    struct rl_pair s_l, s_e, c_l, c_e;
};

static inline struct rl_fur_terms rl_fur_terms(rl_vec3 n, rl_vec3 l, rl_vec3 e)
{
    struct rl_pair_vec3 N = rl_pair_vec3_of(n), L = rl_pair_vec3_of(l), E = rl_pair_vec3_of(e);
    return (struct rl_fur_terms){rl_pair_root(rl_pair_sin_sin(N, L)), rl_pair_root(rl_pair_sin_sin(N, E)),
                                 rl_pair_cosine(N, L), rl_pair_cosine(N, E)};
}

/* cos(psi - theta); below 0 where the eye is more than 90 degrees off the cone. */
static inline struct rl_pair rl_fur_cone(const struct rl_fur_terms *t)
{
    return rl_pair_determinant(t->s_l, t->c_l, t->c_e, t->s_e);
}

/* The size of cos(psi + theta), for the listing squares it three times for an 8th power, which loses its sign. */
static inline struct rl_pair rl_fur_cone_printed(const struct rl_fur_terms *t)
{
    struct rl_pair c = rl_pair_add(rl_pair_multiply(t->s_l, t->s_e), rl_pair_multiply(t->c_l, t->c_e));
    return c.high < 0.0 ? rl_pair_minus(c) : c;
}

/* |n x h|, h = (l + e)/2: by the angles of model/half.h it is sin(delta) cos(beta). */
static inline struct rl_pair rl_fur_half(rl_vec3 n, rl_vec3 l, rl_vec3 e)
{
    struct rl_half half = rl_half_make(l, e);
    if (!(half.cosine.high > 0.0))
        return (struct rl_pair){0.0, 0.0};
    return rl_pair_multiply(half.cosine, rl_pair_root(rl_pair_sin_sin(rl_pair_vec3_of(n), half.H)));
}

/* (1 + kappa)/2 and (1 - kappa)/2, the shares of the light's side and of the other. Where kappa is +-1 one of them is small: with
 * a = (n x l)/max(|n x l|, RL_FUR_PARALLEL), and b of e likewise,
 *
 *     1 - |kappa| = (1 - kappa^2)/(1 + |kappa|),   1 - kappa^2 = |a x b|^2 + (1 - |a|^2) + |a|^2 (1 - |b|^2)    (Lagrange)
 *
 * where the last two are 0 but for directions that are all but parallel, and (n x l) x (n x e) = n (n . (l x e)) is 0 where the three lie in
 * one plane, and not the rest of a difference. */
struct rl_fur_sides {
    double near, far;
};

/* 1 - sine^2 with sine, as a part of RL_FUR_PARALLEL, 1 at most. */
static inline double rl_fur_rest(double sine)
{
    double part = fmin(sine / RL_FUR_PARALLEL, 1.0);
    return (1.0 - part) * (1.0 + part);
}

static inline struct rl_fur_sides rl_fur_sides(const struct rl_fur_terms *t, rl_vec3 n, rl_vec3 l, rl_vec3 e)
{
    struct rl_pair_vec3 N = rl_pair_vec3_of(n), L = rl_pair_vec3_of(l), E = rl_pair_vec3_of(e);
    double m_l = fmax(t->s_l.high, RL_FUR_PARALLEL), m_e = fmax(t->s_e.high, RL_FUR_PARALLEL);
    double across = rl_pair_dot(N, rl_pair_cross(L, E)).high / m_l / m_e;
    double rest = rl_fur_rest(t->s_l.high);
    rest += (1.0 - rest) * rl_fur_rest(t->s_e.high);
    double kappa = rl_pair_dot(rl_pair_cross(N, L), rl_pair_cross(N, E)).high / m_l / m_e;
    double large = 0.5 + 0.5 * fmin(fabs(kappa), 1.0), small = 0.25 * (across * across + rest) / large;
    return kappa < 0.0 ? (struct rl_fur_sides){small, large} : (struct rl_fur_sides){large, small};
}

static inline double rl_fur_kappa(rl_vec3 n, rl_vec3 l, rl_vec3 e)
{
    /* Not near - far: where the angle is about 90 degrees, or no angle at all, both are about 1/2. */
    rl_vec3 a = v3_cross(n, l), b = v3_cross(n, e);
    double kappa = v3_dot(a, b) / (fmax(v3_length(a), RL_FUR_PARALLEL) * fmax(v3_length(b), RL_FUR_PARALLEL));
    /* A cosine rounded beyond 1 would take light away where all is reflected or all transmitted. */
    return fmin(fmax(kappa, -1.0), 1.0);
}

#endif
