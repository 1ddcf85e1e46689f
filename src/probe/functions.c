/* Functions of the model as probes have them (see functions.h). */
#include "probe/functions.h"

#include <string.h>

#include "model/attenuation.h"
#include "model/ellipsoid.h"
#include "model/facets.h"
#include "model/frame.h"
#include "model/fresnel.h"
#include "model/photometry.h"

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
