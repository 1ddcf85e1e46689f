/* The functions of the model as the table of probes (table.c) names them: one row of arguments to one row of results. */
#ifndef RL_PROBE_FUNCTIONS_H
#define RL_PROBE_FUNCTIONS_H

#include "probe/probe.h"

void rl_probe_pdf(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_cdf(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_inverse(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_frame(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_frame_printed(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_attenuation(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_facets_beckmann(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_facets_ellipsoid(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_angle(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_direction(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_mirror(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_luminance(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_fresnel_index(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_fresnel(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_point_light(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_random_bits(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_random_uniform(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_flux(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_sine_squared(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_half(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_lobe(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_fur_sine(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_fur_cone(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_fur_cone_printed(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_fur_half(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_fur_kappa(const struct rl_probe *probe, const double *in, double *out);
void rl_probe_crossing(const struct rl_probe *probe, const double *in, double *out);

#endif
