/* Tangent frames: the default one, and the one the paper prints (see frame.h). */
#include "model/frame.h"

/* Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin: Building an Orthonormal Basis, Revisited. JCGT 6 (1), 2017. */
static struct rl_frame orthonormal(rl_vec3 N)
{
    double sign = copysign(1.0, N.z);
    double a = -1.0 / (sign + N.z);
    double b = N.x * N.y * a;
    return (struct rl_frame){
        .T = v3(1.0 + sign * N.x * N.x * a, sign * b, -sign * N.x),
        .B = v3(b, sign + N.y * N.y * a, -N.y),
        .N = N,
    };
}

static struct rl_frame printed(rl_vec3 N)
{
    return (struct rl_frame){
        .T = v3(0.0, N.z, -N.y),
        .B = v3(N.y * N.y + N.z * N.z, -N.x * N.y, -N.x * N.z),
        .N = N,
    };
}

struct rl_frame rl_frame_make(enum rl_frame_kind kind, rl_vec3 N)
{
    return kind == RL_FRAME_PRINTED ? printed(N) : orthonormal(N);
}

const char *rl_frame_name(enum rl_frame_kind kind)
{
    return kind == RL_FRAME_PRINTED ? "printed" : "orthonormal";
}
