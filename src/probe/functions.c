/* Functions of the model as probes have them (see functions.h). */
#include "probe/functions.h"

#include <stdint.h>
#include <string.h>

#include "model/attenuation.h"
#include "model/ellipsoid.h"
#include "model/facets.h"
#include "model/frame.h"
#include "model/fresnel.h"
#include "model/fur.h"
#include "model/half.h"
#include "model/lobe.h"
#include "model/photometry.h"
#include "model/random.h"
#include "reference/axes.h"

void rl_probe_pdf(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    struct rl_ellipsoid e = rl_ellipsoid_make(in[0]);
    out[0] = rl_ellipsoid_pdf(&e, in[1]);
}

void rl_probe_cdf(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    struct rl_ellipsoid e = rl_ellipsoid_make(in[0]);
    out[0] = rl_ellipsoid_cdf(&e, in[1]);
}

void rl_probe_inverse(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    struct rl_ellipsoid e = rl_ellipsoid_make(in[0]);
    struct rl_delta d = rl_ellipsoid_inverse(&e, in[1]);
    out[0] = d.delta;
    out[1] = d.sin_delta;
    out[2] = d.cos_delta;
}

static void make_frame(enum rl_frame_kind kind, const double *in, double *out)
{
    struct rl_frame f = rl_frame_make(kind, v3_normalize(v3(in[0], in[1], in[2])));
    const double columns[6] = {f.T.x, f.T.y, f.T.z, f.B.x, f.B.y, f.B.z};
    memcpy(out, columns, sizeof columns);
}

void rl_probe_frame(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    make_frame(RL_FRAME_ORTHONORMAL, in, out);
}

void rl_probe_frame_printed(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    make_frame(RL_FRAME_PRINTED, in, out);
}

void rl_probe_attenuation(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_attenuation(in[0], in[1], in[2], in[3]);
}

void rl_probe_facets_beckmann(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_facets_beckmann(cos(in[1]), sin(in[1]) * sin(in[1]), in[0]);
}

void rl_probe_facets_ellipsoid(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_facets_ellipsoid(cos(in[1]), sin(in[1]) * sin(in[1]), in[0]);
}

void rl_probe_angle(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = atan2(in[0], in[1] + 0.0); /* of 0, 0 it is 0, whatever their signs */
}

static void write_vector(double *out, rl_vec3 a)
{
    out[0] = a.x;
    out[1] = a.y;
    out[2] = a.z;
}

void rl_probe_direction(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    write_vector(out, v3_normalize(v3(in[0], in[1], in[2])));
}

void rl_probe_mirror(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    write_vector(out,
                 v3_reflect(v3_normalize(v3(in[3], in[4], in[5])), v3_normalize(v3(in[0], in[1], in[2]))));
}

void rl_probe_luminance(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_luminance(in);
}

void rl_probe_fresnel_index(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_fresnel_index(in[0]).n;
}

void rl_probe_fresnel(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_fresnel(in[0], in[1], in[2]);
}

void rl_probe_point_light(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    const struct rl_source source = {.at = v3(in[3], in[4], in[5]), .strength = {1.0, 1.0, 1.0}};
    struct rl_incident incident;
    if (!rl_incident_from_source(&incident, &source, v3(in[0], in[1], in[2])))
        incident = (struct rl_incident){.L = {0.0, 0.0, 1.0}};
    const double results[4] = {incident.L.x, incident.L.y, incident.L.z, incident.irradiance[0]};
    memcpy(out, results, sizeof results);
}

/* ---- Random numbers ---- */

/* A number of 64 bits from its two words; the lower one may be 2^32, as a word is once it is rounded to single precision. */
static uint64_t from_words(const double *high_low)
{
    return ((uint64_t)high_low[0] << 32) + (uint64_t)high_low[1];
}

/* By parts that single precision holds: the first 24 bits, the next 24, and the last 16. */
void rl_probe_random_bits(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    uint64_t bits = rl_random_bits(from_words(in), from_words(in + 2));
    out[0] = (double)(bits >> 40);
    out[1] = (double)(bits >> 16 & 0xffffff);
    out[2] = (double)(bits & 0xffff);
}

void rl_probe_random_uniform(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_random_uniform(from_words(in), from_words(in + 2));
}

/* ---- Photometry ---- */

void rl_probe_flux(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_flux_of_polygon(in[0], 1);
    out[1] = rl_flux_of_polygon(in[0], 2);
    out[2] = rl_flux_of_body(in[0]);
    out[3] = in[1] * rl_flux_of_point();
}

/* ---- Terms of highlights ---- */

static rl_vec3 read_direction(const double *in)
{
    return v3_normalize(v3(in[0], in[1], in[2]));
}

void rl_probe_sine_squared(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    struct rl_pair_vec3 a = rl_pair_vec3_of(read_direction(in)), b = rl_pair_vec3_of(read_direction(in + 3));
    struct rl_pair cosine = rl_pair_cosine(a, b), sin_sin = rl_pair_sin_sin(a, b);
    out[0] = sin_sin.high;
    /* Beyond 90 degrees nothing cancels. */
    out[1] = cosine.high > 0.0 ? rl_one_less_cosine(cosine, sin_sin).high : 1.0 - cosine.high;
}

void rl_probe_half(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    struct rl_half h = rl_half_make(read_direction(in), read_direction(in + 3));
    bool opposite = !(h.cosine.high > 0.0);
    write_vector(out, opposite ? v3(0.0, 0.0, 0.0) : v3_normalize(v3(h.H.x.high, h.H.y.high, h.H.z.high)));
    out[3] = h.cosine.high;
    out[4] = h.sin_sin.high;
}

static struct rl_pair cosine_of(const double *in)
{
    return rl_pair_cosine(rl_pair_vec3_of(read_direction(in)), rl_pair_vec3_of(read_direction(in + 3)));
}

void rl_probe_lobe(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_power(cosine_of(in), in[6]);
}

/* ---- Terms of fur: n, l, e ---- */

static struct rl_fur_terms read_terms(const double *in)
{
    return rl_fur_terms(read_direction(in), read_direction(in + 3), read_direction(in + 6));
}

void rl_probe_fur_sine(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_fur_sine(read_direction(in), read_direction(in + 3));
}

void rl_probe_fur_cone(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    struct rl_fur_terms t = read_terms(in);
    out[0] = rl_power(rl_fur_cone(&t), in[9]);
}

void rl_probe_fur_cone_printed(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    struct rl_fur_terms t = read_terms(in);
    out[0] = rl_power(rl_fur_cone_printed(&t), in[9]);
}

void rl_probe_fur_half(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    out[0] = rl_fur_half(read_direction(in), read_direction(in + 3), read_direction(in + 6)).high;
}

void rl_probe_fur_kappa(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    rl_vec3 n = read_direction(in), l = read_direction(in + 3), e = read_direction(in + 6);
    struct rl_fur_terms t = rl_fur_terms(n, l, e);
    struct rl_fur_sides sides = rl_fur_sides(&t, n, l, e);
    out[0] = rl_fur_kappa(n, l, e);
    out[1] = sides.near;
    out[2] = sides.far;
}

/* ---- The reference's lines ---- */

/* delta where the line of azimuth theta crosses the great circle of normal m, downwards and upwards, as line.c has it. */
void rl_probe_crossing(const struct rl_probe *probe, const double *in, double *out)
{
    (void)probe;
    rl_vec3 V = read_direction(in), m = read_direction(in + 3);
    struct rl_lines lines = {.v_x = V.x, .v_y = V.y, .v_n = V.z};
    struct rl_axes axes = rl_axes_make(&lines, cos(in[6]), sin(in[6]));
    for (size_t up = 0; up < 2; up++) {
        struct rl_on_line L = rl_axes_cross(&axes, m, up != 0);
        struct rl_angle normal = rl_axes_normal(&axes, L.t, L.n);
        out[2 * up] = normal.s;
        out[2 * up + 1] = normal.c;
    }
}
