/* A tangent frame (T, B) about a unit normal N. */
#ifndef RL_MODEL_FRAME_H
#define RL_MODEL_FRAME_H

#include "model/vec3.h"

enum rl_frame_kind {
    RL_FRAME_ORTHONORMAL, /* Duff et al. 2017: unit length for every N, no branch; (T, B, N) right-handed */
    RL_FRAME_PRINTED /* rows as Kimura and Tokoi print them; length sqrt(n_y^2 + n_z^2), zero at N = +-x */
};

struct rl_frame {
    rl_vec3 T, B, N;
};

/* N must be a unit vector. */
struct rl_frame rl_frame_make(enum rl_frame_kind kind, rl_vec3 N);

/* "orthonormal" or "printed". */
const char *rl_frame_name(enum rl_frame_kind kind);

/* a along T, B and N. */
static inline rl_vec3 rl_frame_components(const struct rl_frame *f, rl_vec3 a)
{
    return v3(v3_dot(f->T, a), v3_dot(f->B, a), v3_dot(f->N, a));
}

/* cos(delta) N + sin(delta) (cos(theta) T + sin(theta) B); unit only in a frame that is. */
static inline rl_vec3 rl_frame_microfacet_normal(const struct rl_frame *f, double sin_delta, double cos_delta,
                                                 double theta)
{
    rl_vec3 h = v3_scale(cos_delta, f->N);
    h = v3_madd(h, sin_delta * cos(theta), f->T);
    return v3_madd(h, sin_delta * sin(theta), f->B);
}

#endif
