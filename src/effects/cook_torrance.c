/* Cook and Torrance's highlight (1982): microfacets that mirror by Fresnel's law, distributed by D, masked and shadowed by G.
 *
 *     F(beta) D(delta) G / (4 N.V),   N.L > 0 and N.V > 0
 *
 * times the irradiance perpendicular to L, with H = (L + V)/|L + V|, cos(delta) = N.H, cos(beta) = V.H = L.H. As a reflectance that is
 * F D G / (4 (N.L)(N.V)): the paper prints F D G / (pi (N.L)(N.V)) with a D that lacks the pi of a density; with D normalized to
 * integral of D cos(delta) = 1 what conserves energy has the 4 (Torrance and Sparrow 1967; it is |dH/dL| = 1/(4 V.H)).
 *
 * F (src/model/fresnel.h) depends on the wavelength by n and k for each of R, G and B; or by the reflectance at normal incidence, from
 * which follows n with k = 0, as the paper does. D is Beckmann's or the ellipsoid's (src/model/facets.h). G is that of V-shaped grooves
 * (src/model/attenuation.h), which never hides more than it must: all of it together reflects less than it receives, whatever m, and is
 * the same with light and eye exchanged. Highlight of the paper only: its diffuse part is the effect `diffuse`.
 *
 * It jumps at the eye's horizon. As N.V falls to 0 masking does, too, G/(4 N.V) = (N.H)/(2 V.H), and N.H = N.L/(2 V.H): the limit from above
 * is finite, F(beta) D(delta) N.L/(4 (V.H)^2), and not 0. At N.V = 0 and below, where an interpolated normal may be though the surface is
 * seen, nothing is. At the light's horizon there is no jump: shadowing takes it to 0 with N.L. */
#include <float.h>

#include "effects/highlight.h"
#include "model/facets.h"
#include "model/half.h"

enum { ROUGHNESS = 9, DISTRIBUTION = 10 };

static void pack(const double *value, double params[][4])
{
    rl_reflectance_pack(value, params);
    params[0][3] = value[ROUGHNESS];
    params[1][3] = value[DISTRIBUTION];
}

static void reflect(const struct rl_surface *s, rl_vec3 L, double params[][4], double rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    struct rl_pair_vec3 N = rl_pair_vec3_of(s->N);
    struct rl_pair n_l = rl_pair_cosine(N, rl_pair_vec3_of(L)),
                   n_v = rl_pair_cosine(N, rl_pair_vec3_of(s->V));
    /* Level with the surface as plain numbers have it for other effects, too, or as pairs know better: none. */
    if (!(v3_dot(s->N, L) > 0.0) || !(v3_dot(s->N, s->V) > 0.0) || !(n_l.high > 0.0) || !(n_v.high > 0.0))
        return;
    struct rl_half h = rl_half_make(L, s->V);
    if (!(h.cosine.high > 0.0))
        return;
    /* A sum of what is positive: N.H of a rounded H may be below 0 at grazing incidence. */
    struct rl_pair n_h = rl_pair_divide(rl_pair_scale(0.5, rl_pair_add(n_l, n_v)), h.cosine);
    double cos_delta = fmin(1.0, n_h.high), sin_sin = rl_pair_sin_sin(N, h.H).high, m = params[0][3];
    double d = params[1][3] == 0.0 ? rl_facets_beckmann(cos_delta, sin_sin, m)
                                   : rl_facets_ellipsoid(cos_delta, sin_sin, m);
    /* G / (4 N.V), G = min(1, 2 (N.H) min(N.V, N.L)/(V.H)): quotients of what goes to 0 together, and no product of them. */
    struct rl_pair hidden = rl_pair_divide(rl_pair_scale(0.5, n_h), h.cosine);
    if (n_l.high < n_v.high)
        hidden = rl_pair_multiply(hidden, rl_pair_divide(n_l, n_v));
    double g = fmin(0.25 / n_v.high, hidden.high);
    /* At a grazing angle of 1e-308 it is past the largest number; an infinity times an F of 0 is none at all. */
    double factor = fmin(d * g, DBL_MAX);
    for (int c = 0; c < 3; c++)
        rgb[c] = rl_reflectance_at(params, c, h.cosine.high, h.sin_sin.high) * factor;
}

static const struct rl_effect_choice distribution[] = {
    {"beckmann", "common/beckmann"}, {"ellipsoid", "common/ellipsoid_facets"}, {0}};

static const struct rl_effect_param param[] = {
    RL_REFLECTANCE_KEYS,
    {.key = "roughness",
     .help = "m: the facets' rms slope for beckmann, 1/R_r for ellipsoid",
     .low = 0.001,
     .high = 10.0,
     .required = true},
    {.key = "distribution",
     .help = "of the facets' normals",
     .kind = RL_EFFECT_CHOICE,
     .choice = distribution},
    {0},
};

const struct rl_effect rl_effect_cook_torrance = {
    .name = "cook-torrance",
    .summary =
        "F D G / (4 N.V): microfacets with Fresnel's reflectance, in light of points and parallel light",
    .sees = RL_SEES_SOURCES,
    .roles = RL_ROLE_SPECULAR,
    .param = param,
    .modules = {"common/half", "common/fresnel"},
    .check = rl_reflectance_check,
    .n_params = RL_REFLECTANCE_PARAMS,
    .pack = pack,
    .reflect = reflect,
    .absolute = 1e-6,
    .relative = 1e-5,
};
