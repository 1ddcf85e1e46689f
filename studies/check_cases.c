/* The cases of the check, one line each. A case's seeds follow from its place: new ones go to the end, else the baseline of those behind
 * them is still right but no longer what its command writes. */
#include "studies/check_parts.h"
#include "studies/study.h"

#define SIZE " width=160 height=120"
#define MODEL(parameters)                                                                                    \
    {                                                                                                        \
        RL_NO_SCENE, parameters, false, rl_check_model, NULL                                                 \
    }
#define POINT(parameters)                                                                                    \
    {                                                                                                        \
        RL_NO_SCENE, parameters, false, rl_check_point, NULL                                                 \
    }
#define MAP(parameters)                                                                                      \
    {                                                                                                        \
        RL_NO_SCENE, parameters, true, rl_check_map, NULL                                                    \
    }
#define ROUNDING(parameters)                                                                                 \
    {                                                                                                        \
        RL_NO_SCENE, "rounding=" parameters, false, rl_check_rounding, NULL                                  \
    }
#define GENERATOR(name)                                                                                      \
    {                                                                                                        \
        RL_NO_SCENE,                                                                                         \
            "series=point generator=" name                                                                   \
            " normal_bits=float samples=4 rr=30 normal_size=128 size=32 step=0",                             \
            true, rl_check_generator, NULL                                                                   \
    }
#define REFERENCE(scene, parameters)                                                                         \
    {                                                                                                        \
        scene, "method=reference " parameters SIZE, false, rl_check_reference, NULL                          \
    }
#define FIXED(scene, parameters)                                                                             \
    {                                                                                                        \
        scene, "method=" parameters SIZE, false, rl_check_fixed_picture, rl_check_release_picture            \
    }
#define RANDOM(scene, parameters)                                                                            \
    {                                                                                                        \
        scene, "method=random " parameters " normal_size=256" SIZE, true, rl_check_random_picture,           \
            rl_check_release_picture                                                                         \
    }

const struct rl_check_case rl_check_cases[] = {
    MODEL("function=pdf rr=1"),
    MODEL("function=pdf rr=3"),
    MODEL("function=pdf rr=30"),
    MODEL("function=pdf rr=300"),
    MODEL("function=cdf rr=1"),
    MODEL("function=cdf rr=3"),
    MODEL("function=cdf rr=30"),
    MODEL("function=cdf rr=300"),
    MODEL("function=inverse rr=1"),
    MODEL("function=inverse rr=3"),
    MODEL("function=inverse rr=30"),
    MODEL("function=inverse rr=300"),
    MODEL("function=attenuation"),
    MODEL("function=frame frame=orthonormal"),
    MODEL("function=frame frame=printed"),
    MODEL("function=pattern method=regular samples=13 rr=3"),
    MODEL("function=pattern method=regular samples=13 rr=30"),
    MODEL("function=pattern method=regular samples=13 rr=300"),
    MODEL("function=pattern method=regular samples=50 rr=30"),
    POINT("point=overhead rr=30 method=reference"),
    POINT("point=grazing rr=3 method=reference"),
    POINT("point=horizon rr=10 method=reference"),
    POINT("point=small rr=300 method=reference"),
    POINT("point=star rr=30 method=reference"),
    POINT("point=star rr=30 method=reference attenuation=off"),
    POINT("point=two rr=5 method=reference"),
    POINT("point=overhead rr=10 method=reference frame=printed"),
    POINT("point=horizon rr=10 method=exhaustive env_size=64"),
    REFERENCE("sphere-quad", "rr=3"),
    REFERENCE("sphere-quad", "rr=30"),
    REFERENCE("sphere-quad", "rr=300"),
    REFERENCE("teapot-star", "rr=3"),
    REFERENCE("teapot-star", "rr=30"),
    REFERENCE("teapot-star", "rr=300"),
    REFERENCE("three-lights", "rr=3"),
    REFERENCE("three-lights", "rr=30"),
    REFERENCE("three-lights", "rr=300"),
    FIXED("sphere-quad", "plain"),
    FIXED("three-lights", "plain"),
    FIXED("sphere-quad", "regular samples=13 rr=3"),
    FIXED("sphere-quad", "regular samples=13 rr=30"),
    FIXED("sphere-quad", "regular samples=13 rr=300"),
    FIXED("teapot-star", "regular samples=13 rr=3"),
    FIXED("teapot-star", "regular samples=13 rr=30"),
    FIXED("teapot-star", "regular samples=13 rr=300"),
    FIXED("three-lights", "regular samples=13 rr=3"),
    FIXED("three-lights", "regular samples=13 rr=30"),
    FIXED("three-lights", "regular samples=13 rr=300"),
    FIXED("three-lights", "regular samples=50 rr=30 env_size=32"),
    FIXED("three-lights", "regular samples=50 rr=30 env_format=r11g11b10f"),
    FIXED("three-lights", "regular samples=50 rr=30 margin=0.25"),
    FIXED("three-lights", "regular samples=50 rr=100 margin=auto"),
    FIXED("three-lights", "regular samples=50 rr=30 frame=printed"),
    MAP("map=random rr=3"),
    MAP("map=random rr=30"),
    MAP("map=random rr=300"),
    MAP("map=random rr=30 normal_bits=10"),
    MAP("map=random rr=30 normal_bits=float"),
    RANDOM("sphere-quad", "samples=4 rr=3"),
    RANDOM("sphere-quad", "samples=4 rr=30"),
    RANDOM("sphere-quad", "samples=4 rr=300"),
    RANDOM("teapot-star", "samples=4 rr=3"),
    RANDOM("teapot-star", "samples=4 rr=30"),
    RANDOM("teapot-star", "samples=4 rr=300"),
    RANDOM("three-lights", "samples=4 rr=3"),
    RANDOM("three-lights", "samples=4 rr=30"),
    RANDOM("three-lights", "samples=4 rr=300"),
    RANDOM("two-roughness", "samples=4"),
    RANDOM("three-lights", "samples=64 rr=10"),
    RANDOM("teapot-star", "samples=16 rr=30 frame=printed"),
    POINT("point=grazing rr=3 method=reference simd=plain"),
    POINT("point=horizon rr=10 method=reference simd=plain"),
    POINT("point=star rr=0.5 method=reference"),
    POINT("point=horizon rr=10 method=reference frame=printed"),
    MODEL("function=metrics"),
    REFERENCE("ball-shadow", "rr=2 eye=low"),
    FIXED("ball-shadow", "regular samples=50 rr=2 eye=low"),
    RANDOM("ball-shadow", "samples=4 rr=2 eye=low"),
    ROUNDING("map normal_bits=4"),
    ROUNDING("map normal_bits=5"),
    ROUNDING("map normal_bits=6"),
    ROUNDING("map normal_bits=8"),
    ROUNDING("map normal_bits=10"),
    ROUNDING("map normal_bits=12"),
    ROUNDING("map normal_bits=16"),
    ROUNDING("map normal_bits=half"),
    ROUNDING("map normal_bits=float"),
    ROUNDING("environment env_format=rgba8"),
    ROUNDING("environment env_format=rgb10a2"),
    ROUNDING("environment env_format=r11g11b10f"),
    ROUNDING("environment env_format=rgba16"),
    ROUNDING("environment env_format=rgba16f"),
    GENERATOR("baked"),
    GENERATOR("hash"),
};

const size_t rl_n_check_cases = sizeof rl_check_cases / sizeof rl_check_cases[0];
