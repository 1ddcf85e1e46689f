/* Tangent frames: the default one, and the one the paper prints (see frame.h). */
#include "model/frame.h"

/* Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin: Building an Orthonormal Basis, Revisited. JCGT 6 (1), 2017.
 *
 * The paper has 1 - x^2/(1 + |z|) and 1 - y^2/(1 + |z|) on the diagonal, which cancel where N is near +-x or +-y. As x^2 + y^2 + z^2 = 1
 * they are |z| + y^2/(1 + |z|) and |z| + x^2/(1 + |z|). */
static struct rl_frame orthonormal(rl_vec3 N)
{
    double sign = copysign(1.0, N.z);
    double z = fabs(N.z), x_over = N.x / (1.0 + z), y_over = N.y / (1.0 + z);
    double b = -N.x * y_over;
    return (struct rl_frame){
        .T = v3(z + N.y * y_over, b, -sign * N.x),
        .B = v3(sign * b, sign * (z + N.x * x_over), -N.y),
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
