/* The table of probes: one row for each function of the model. */
#include <stdio.h>
#include <string.h>

#include "probe/columns.h"
#include "probe/functions.h"

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
        .in = {{.name = "r", .rounded = true},
               {.name = "g", .rounded = true},
               {.name = "b", .rounded = true}},
        .out = {"y"},
        .cpu = rl_probe_luminance,
        .glsl = "    r[0] = dot(vec3(0.2126, 0.7152, 0.0722), vec3(a[0], a[1], a[2]));\n",
        .absolute = 1e-6,
        .relative = 1e-6,
        .bound = "for colours up to 1e37",
    },
    {
        .name = "reflectance-index",
        .summary = "n of the dielectric that reflects this part at normal incidence",
        .n_in = 1,
        .n_out = 1,
        .in = {{.name = "f", .low = 0.0, .high = 1.0, .rounded = true}},
        .out = {"n"},
        .cpu = rl_probe_fresnel_index,
        /* (1 + sqrt f)/(1 - sqrt f), whose lower part is rounded as 1 - f is not. */
        .glsl = "    float s = 1.0 + sqrt(a[0]);\n"
                "    r[0] = min(s * s / max(1.0 - a[0], 4e-8), 1e8);\n",
        .absolute = 1e-6,
        .relative = 1e-6,
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
        .glsl = "    Incident light = incident(vec3(a[3], a[4], a[5]), vec3(a[0], a[1], a[2]), vec3(1.0));\n"
                "    r = float[](light.L.x, light.L.y, light.L.z, light.irradiance.x);\n",
        .absolute = 1e-6,
        .relative = 1e-6,
        .bound = "for r from 1e-15 to 1e15",
    },
    {
        .name = "sine-squared",
        .summary = "sine squared of the angle between directions, and how much less than 1 its cosine is",
        .n_out = 2,
        .out = {"ss", "less"},
        .cpu = rl_probe_sine_squared,
        OF_TWO(a, b),
        .glsl = "    vec3 c = cross(normalize(vec3(a[0], a[1], a[2])), normalize(vec3(a[3], a[4], a[5])));\n"
                "    vec3 apart = normalize(vec3(a[0], a[1], a[2])) - normalize(vec3(a[3], a[4], a[5]));\n"
                "    r = float[](dot(c, c), 0.5 * dot(apart, apart));\n",
        .absolute = 1e-6,
        .relative = 1e-6,
    },
    {
        .name = "half",
        .summary =
            "H = (L + V)/|L + V|, 0 where they are opposite; cosine and sine squared of the angle to either",
        .n_out = 5,
        .out = {"hx", "hy", "hz", "cosine", "ss"},
        .cpu = rl_probe_half,
        OF_TWO(l, v),
        .modules = {"common/half"},
        .glsl = "    Half h = half_vector(normalize(vec3(a[0], a[1], a[2])), normalize(vec3(a[3], a[4], "
                "a[5])));\n"
                "    vec3 H = h.cosine > 0.0 ? h.H : vec3(0.0);\n"
                "    r = float[](H.x, H.y, H.z, h.cosine, (1.0 - h.cosine) * (1.0 + h.cosine));\n",
        .absolute = 1e-6,
    },
    {
        .name = "lobe",
        .summary = "max(0, a.b)^n of directions",
        .n_in = 7,
        .n_out = 1,
        .n_directions = 2,
        .n_vectors = 2,
        .in = {{.name = "ax"},
               {.name = "ay"},
               {.name = "az"},
               {.name = "bx"},
               {.name = "by"},
               {.name = "bz"},
               EXPONENT(n)},
        .out = {"lobe"},
        .cpu = rl_probe_lobe,
        .modules = {"common/lobe"},
        .glsl = "    r[0] = power_of_cosine(normalize(vec3(a[0], a[1], a[2])), normalize(vec3(a[3], a[4], "
                "a[5])), a[6]);\n",
        .absolute = 1e-6,
        .relative = 1e-5,
    },
    {
        .name = "fur-sine",
        .summary = "|n x l|, a fibre's share of light from l",
        .n_out = 1,
        .out = {"sine"},
        .cpu = rl_probe_fur_sine,
        OF_TWO(n, l),
        .modules = {"common/lobe", "common/fur"},
        .glsl =
            "    r[0] = fur_sine(normalize(vec3(a[0], a[1], a[2])), normalize(vec3(a[3], a[4], a[5])));\n",
        .absolute = 1e-6,
    },
    {
        .name = "fur-cone",
        .summary = "max(0, cos(psi - theta))^p, Kajiya and Kay's highlight of fibres along n",
        .cpu = rl_probe_fur_cone,
        FUR_LOBE("common/fur_cone"),
    },
    {
        .name = "fur-cone-printed",
        .summary = "|cos(psi + theta)|^p, as a listing of it has it",
        .cpu = rl_probe_fur_cone_printed,
        FUR_LOBE("common/fur_cone_printed"),
    },
    {
        .name = "fur-half",
        .summary = "|n x h|, h = (l + e)/2: Lengyel's highlight of fibres along n is a power of it",
        .n_in = 9,
        .n_out = 1,
        .n_directions = 3,
        .n_vectors = 3,
        .in = {FUR_DIRECTIONS},
        .out = {"cosine"},
        .cpu = rl_probe_fur_half,
    },
    {
        .name = "fur-kappa",
        .summary =
            "kappa, Goldman's cosine of the angle about n between l and e; (1 + kappa)/2 and (1 - kappa)/2",
        .n_in = 9,
        .n_out = 3,
        .n_directions = 3,
        .n_vectors = 3,
        .in = {FUR_DIRECTIONS},
        .out = {"kappa", "near", "far"},
        .cpu = rl_probe_fur_kappa,
        .modules = {"common/fur_kappa"},
        .glsl = "    float kappa = fur_kappa(normalize(vec3(a[0], a[1], a[2])), normalize(vec3(a[3], a[4], "
                "a[5])), normalize(vec3(a[6], a[7], a[8])));\n"
                "    r = float[](kappa, 0.5 * (1.0 + kappa), 0.5 * (1.0 - kappa));\n",
        .absolute = 1e-6,
    },
    {
        .name = "flux",
        .summary = "flux of area a and luminance 1: a polygon's one side, both, a closed body; of a point of "
                   "intensity i",
        .n_in = 2,
        .n_out = 4,
        .in = {{.name = "a", .low = 0.0, .high = 1e37}, {.name = "i", .low = 0.0, .high = 1e37}},
        .out = {"side", "sides", "body", "point"},
        .cpu = rl_probe_flux,
        .glsl = "    const float pi = 3.14159265;\n"
                "    r = float[](pi * a[0], 2.0 * pi * a[0], pi * a[0], 4.0 * pi * a[1]);\n",
        .absolute = 1e-37,
        .relative = 1e-6,
    },
    {
        .name = "random-bits",
        .summary = "the 64 bits of (seed, index), both by words of 32 bits; the first 24, then 24, then 16",
        .out = {"first", "middle", "last"},
        .n_out = 3,
        .cpu = rl_probe_random_bits,
        RANDOM_PROBE("    uvec2 b = random_bits(seed, index);\n"
                     "    r = float[](float(b.y >> 8), float((b.y & 255u) << 16 | b.x >> 16),\n"
                     "                float(b.x & 65535u));\n"),
    },
    {
        .name = "random-uniform",
        .summary =
            "the number in (0, 1) of (seed, index), by words of 32 bits; in GLSL the first 23 of its 52 bits",
        .out = {"u"},
        .n_out = 1,
        .cpu = rl_probe_random_uniform,
        RANDOM_PROBE("    r[0] = random_uniform(seed, index);\n"),
        .absolute = 6e-8,
    },
    {
        .name = "crossing",
        .summary =
            "sine and cosine of delta where the line of azimuth theta crosses the great circle of normal m, "
            "both times; of no meaning where they miss each other",
        .n_in = 7,
        .n_out = 4,
        .n_directions = 2,
        .n_vectors = 2,
        .in = {{.name = "vx"},
               {.name = "vy"},
               {.name = "vz", .low = 0.0, .high = 1e300},
               {.name = "mx"},
               {.name = "my"},
               {.name = "mz"},
               {.name = "theta", .low = -RL_PI, .high = RL_PI}},
        .out = {"down_sine", "down_cosine", "up_sine", "up_cosine"},
        .cpu = rl_probe_crossing,
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
