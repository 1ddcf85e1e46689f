/* The table of probes: one row for each function of the model. */
#include <stdio.h>
#include <string.h>

#include "model/ellipsoid.h"
#include "probe/functions.h"

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
/* clang-format on */

static const struct rl_probe probes[] = {
    {
        .name = "ellipsoid-pdf",
        .summary = "D(delta), the ellipsoid distribution's density per radian",
        .n_in = 2,
        .n_out = 1,
        .in = {RR, DELTA},
        .out = {"pdf"},
        .cpu = rl_probe_pdf,
        .modules = {"common/arctangent", "common/sine_cosine", "common/ellipsoid"},
        .glsl = "    r[0] = ellipsoid_pdf(ellipsoid_make(a[0]), a[1]);\n",
        .absolute = 1e-6,
        .relative = 1e-5,
    },
    {
        .name = "ellipsoid-cdf",
        .summary = "U(delta), its integral from -pi/2",
        .n_in = 2,
        .n_out = 1,
        .in = {RR, DELTA},
        .out = {"u"},
        .cpu = rl_probe_cdf,
        .modules = {"common/arctangent", "common/sine_cosine", "common/ellipsoid"},
        .glsl = "    r[0] = ellipsoid_cdf(ellipsoid_make(a[0]), a[1]);\n",
        .absolute = 1e-6,
        .relative = 1e-5,
    },
    {
        .name = "ellipsoid-inverse",
        .summary = "delta(U), and its sine and cosine",
        .n_in = 2,
        .n_out = 3,
        .in = {RR, {.name = "u", .low = 0.0, .high = 1.0, .rounded = true}},
        .out = {"delta", "sin_delta", "cos_delta"},
        .cpu = rl_probe_inverse,
        .modules = {"common/arctangent", "common/sine_cosine", "common/ellipsoid"},
        .glsl = "    vec3 d = ellipsoid_inverse(ellipsoid_make(a[0]), a[1]);\n"
                "    r = float[](d.x, d.y, d.z);\n",
        .absolute = 1e-6,
        .relative = 1e-5,
    },
    {
        .name = "frame",
        .summary = "an orthonormal tangent frame about N",
        .cpu = rl_probe_frame,
        .modules = {"common/frame"},
        FRAME_PROBE,
    },
    {
        .name = "frame-printed",
        .summary = "the tangent frame about N as the paper prints it",
        .cpu = rl_probe_frame_printed,
        .modules = {"common/frame_printed"},
        FRAME_PROBE,
    },
    {
        .name = "attenuation",
        .summary = "G, masking and shadowing of V-shaped grooves, from cosines",
        .n_in = 4,
        .n_out = 1,
        .in = {{.name = "n_h", OF_COSINE},
               {.name = "n_v", OF_COSINE},
               {.name = "n_l", OF_COSINE},
               {.name = "v_h", OF_COSINE}},
        .out = {"g"},
        .cpu = rl_probe_attenuation,
        .modules = {"common/attenuation"},
        .glsl = "    r[0] = attenuation(a[0], a[1], a[2], a[3]);\n",
        .absolute = 1e-37,
        .relative = 1e-6,
    },
    {
        .name = "facets-beckmann",
        .summary = "D(delta) of Beckmann's distribution, normals per steradian; m: rms slope",
        .cpu = rl_probe_facets_beckmann,
        FACETS_PROBE("common/beckmann"),
    },
    {
        .name = "facets-ellipsoid",
        .summary = "D(delta) of the ellipsoid over solid angle, normals per steradian; m = 1/R_r",
        .cpu = rl_probe_facets_ellipsoid,
        FACETS_PROBE("common/ellipsoid_facets"),
    },
    {
        .name = "angle",
        .summary = "the angle, 0 to pi, whose sine and cosine are as y >= 0 to x",
        .n_in = 2,
        .n_out = 1,
        .in = {{.name = "y", .low = 0.0, .high = 1e18}, {.name = "x"}},
        .out = {"angle"},
        .cpu = rl_probe_angle,
        .modules = {"common/arctangent"},
        .glsl = "    r[0] = angle_of(a[0], a[1]);\n",
        .absolute = 1e-6,
        .relative = 1e-6,
    },
    {
        .name = "direction",
        .summary = "a vector of any length made unit",
        .n_in = 3,
        .n_out = 3,
        .n_directions = 1,
        .n_vectors = 1,
        .in = {{.name = "x"}, {.name = "y"}, {.name = "z"}},
        .out = {"ux", "uy", "uz"},
        .cpu = rl_probe_direction,
        .glsl = "    vec3 u = normalize(vec3(a[0], a[1], a[2]));\n"
                "    r = float[](u.x, u.y, u.z);\n",
        .absolute = 1e-6,
    },
    {
        .name = "mirror",
        .summary = "L = 2 (N.V) N - V, V mirrored about N",
        .n_in = 6,
        .n_out = 3,
        .n_directions = 2,
        .n_vectors = 2,
        .in =
            {{.name = "nx"}, {.name = "ny"}, {.name = "nz"}, {.name = "vx"}, {.name = "vy"}, {.name = "vz"}},
        .out = {"lx", "ly", "lz"},
        .cpu = rl_probe_mirror,
        .glsl =
            "    vec3 l = reflect(-normalize(vec3(a[3], a[4], a[5])), normalize(vec3(a[0], a[1], a[2])));\n"
            "    r = float[](l.x, l.y, l.z);\n",
        .absolute = 1e-6,
    },
    {
        .name = "luminance",
        .summary = "luminance of linear RGB, primaries and white of BT.709",
        .n_in = 3,
        .n_out = 1,
        .in = {{.name = "r"}, {.name = "g"}, {.name = "b"}},
        .out = {"y"},
        .cpu = rl_probe_luminance,
    },
    {
        .name = "reflectance-index",
        .summary = "n of the dielectric that reflects this part at normal incidence",
        .n_in = 1,
        .n_out = 1,
        .in = {{.name = "f", .low = 0.0, .high = 1.0}},
        .out = {"n"},
        .cpu = rl_probe_fresnel_index,
    },
    {
        .name = "reflectance",
        .summary =
            "F, unpolarised reflectance at a medium of index n - i k; c: cosine of the angle of incidence",
        .n_in = 3,
        .n_out = 1,
        .in = {{.name = "n", .low = 0.01, .high = 1e8, .rounded = true},
               {.name = "k", .low = 0.0, .high = 100.0},
               {.name = "c", .low = 0.0, .high = 1.0, .rounded = true}},
        .out = {"f"},
        .cpu = rl_probe_fresnel,
        .modules = {"common/fresnel"},
        .glsl = "    r[0] = fresnel(vec3(a[0]), vec3(a[1]), vec3((a[0] - 1.0) * (a[0] + 1.0)), a[2],\n"
                "                   (1.0 - a[2]) * (1.0 + a[2])).x;\n",
        .absolute = 1e-6,
    },
    {
        .name = "point-light",
        .summary =
            "direction from P to a point light at Q of intensity 1, and its irradiance 1/r^2; 0 where Q = P",
        .n_in = 6,
        .n_out = 4,
        .in =
            {{.name = "px"}, {.name = "py"}, {.name = "pz"}, {.name = "qx"}, {.name = "qy"}, {.name = "qz"}},
        .out = {"lx", "ly", "lz", "e"},
        .cpu = rl_probe_point_light,
        .modules = {"common/incident"},
        .glsl = "    Incident light = incident(vec3(a[3], a[4], a[5]) - vec3(a[0], a[1], a[2]), vec3(1.0));\n"
                "    r = float[](light.L.x, light.L.y, light.L.z, light.irradiance.x);\n",
        .absolute = 1e-6,
        .relative = 1e-6,
        .bound = "for r from 1e-15 to 1e15",
    },
};

enum { N_PROBES = sizeof probes / sizeof probes[0] };

bool rl_probe_at(struct rl_probe *probe, size_t i)
{
    if (i < N_PROBES) {
        *probe = probes[i];
        return true;
    }
    size_t at = N_PROBES;
    for (size_t row = 0; row < rl_n_effects; row++)
        for (int polygon = 0; polygon < 2; polygon++)
            if (rl_probe_of_effect(probe, rl_effects[row], polygon != 0) && at++ == i)
                return true;
    return false;
}

int rl_probe_find(struct rl_probe *probe, const char *name, struct rl_error *error)
{
    char names[768] = "";
    size_t used = 0;
    for (size_t i = 0; rl_probe_at(probe, i); i++) {
        if (strcmp(probe->name, name) == 0)
            return RL_OK;
        int n = snprintf(names + used, sizeof names - used, "%s%s", i ? ", " : "", probe->name);
        used += n > 0 && (size_t)n < sizeof names - used ? (size_t)n : 0;
    }
    return rl_fail(error, RL_ERR_INPUT, "function '%.64s': expected one of %s", name, names);
}
