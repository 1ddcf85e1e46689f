/* What several rows of the table of probes (table.c) share: columns of arguments, and GLSL. */
#ifndef RL_PROBE_COLUMNS_H
#define RL_PROBE_COLUMNS_H

#include "model/ellipsoid.h"
#include "probe/probe.h"

/* clang-format off */
/* Columns that several probes have. */
#define RR {.name = "rr", .low = RL_RR_MIN, .high = RL_RR_MAX, .rounded = true}
#define DELTA {.name = "delta", .low = -0.5 * RL_PI, .high = 0.5 * RL_PI, .rounded = true}
#define OF_COSINE .low = -1.0, .high = 1.0

/* Of both distributions over solid angle. */
#define FACETS_PROBE(module) \
    .n_in = 2, .n_out = 1, \
    .in = {{.name = "m", .low = 1.0 / RL_RR_MAX, .high = 1.0 / RL_RR_MIN, .rounded = true}, DELTA}, \
    .out = {"d"}, \
    .modules = {"common/sine_cosine", module}, \
    .glsl = "    vec2 sc = sine_cosine(abs(a[1]));\n" \
            "    r[0] = facets(sc.y, sc.x * sc.x, a[0]);\n", \
    .absolute = 1e-6, .relative = 1e-5

/* Of both frames: columns, and GLSL where the module is linked that the probe names. */
#define FRAME_PROBE \
    .n_in = 3, .n_out = 6, .n_directions = 1, .n_vectors = 1, \
    .in = {{.name = "nx"}, {.name = "ny"}, {.name = "nz"}}, \
    .out = {"tx", "ty", "tz", "bx", "by", "bz"}, \
    .glsl = "    mat3 f = tangent_frame(normalize(vec3(a[0], a[1], a[2])));\n" \
            "    for (int i = 0; i < 6; i++)\n" \
            "        r[i] = f[1 + i / 3][i % 3];\n", \
    .absolute = 1e-6

/* Of two directions, by the letters that columns are named after. */
#define OF_TWO(a, b) \
    .n_in = 6, .n_directions = 2, .n_vectors = 2, \
    .in = {{.name = #a "x"}, {.name = #a "y"}, {.name = #a "z"}, {.name = #b "x"}, {.name = #b "y"}, {.name = #b "z"}}
#define EXPONENT(called) {.name = #called, .low = 1.0, .high = 1000.0, .rounded = true}

/* Of fur: columns, and GLSL of both cones. */
#define FUR_DIRECTIONS \
    {.name = "nx"}, {.name = "ny"}, {.name = "nz"}, {.name = "lx"}, {.name = "ly"}, {.name = "lz"}, \
    {.name = "ex"}, {.name = "ey"}, {.name = "ez"}
#define FUR_LOBE(module) \
    .n_in = 10, .n_out = 1, .n_directions = 3, .n_vectors = 3, \
    .in = {FUR_DIRECTIONS, EXPONENT(p)}, \
    .out = {"lobe"}, \
    .modules = {"common/lobe", "common/fur", module}, \
    .glsl = "    vec3 n = normalize(vec3(a[0], a[1], a[2]));\n" \
            "    vec3 l = normalize(vec3(a[3], a[4], a[5]));\n" \
            "    r[0] = fur_cone(n, l, normalize(vec3(a[6], a[7], a[8])), a[9]);\n", \
    .absolute = 1e-6, .relative = 1e-5

/* Of random numbers: columns, and GLSL with seed and index at hand. A word may have been rounded to 2^32. */
#define WORD .low = 0.0, .high = 4294967295.0, .whole = true
#define RANDOM_PROBE(text) \
    .n_in = 4, \
    .in = {{.name = "seed_high", WORD}, {.name = "seed_low", WORD}, \
           {.name = "index_high", WORD}, {.name = "index_low", WORD}}, \
    .modules = {"common/random"}, \
    .glsl = "    const float base = 4294967296.0;\n" \
            "    uvec2 word[2];\n" \
            "    for (int i = 0; i < 2; i++) {\n" \
            "        float high = a[2 * i] < base ? a[2 * i] : 0.0;\n" \
            "        float low = a[2 * i + 1];\n" \
            "        word[i] = low < base ? uvec2(uint(low), uint(high)) : uvec2(0u, uint(high) + 1u);\n" \
            "    }\n" \
            "    uvec2 seed = word[0];\n" \
            "    uvec2 index = word[1];\n" text
/* clang-format on */

#endif
