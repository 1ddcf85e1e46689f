/* The terms of fur models, evaluated in double precision (see fur.h). */
#include "model/fur.h"

#include <math.h>
#include <string.h>

#include "effects/effect.h"
#include "model/random.h"
#include "studies/fur.h"

static int add(struct rl_record *r, const char *name, double value, struct rl_error *error)
{
    return rl_record_add_exact(r, name, value, "1", error);
}

/* ---- Identities ---- */

enum { SEED = 11 };

static rl_vec3 direction(uint64_t *at)
{
    double z = 2.0 * rl_random_uniform(SEED, (*at)++) - 1.0;
    double azimuth = 2.0 * RL_PI * rl_random_uniform(SEED, (*at)++), s = sqrt(1.0 - z * z);
    return v3(s * cos(azimuth), s * sin(azimuth), z);
}

/* Goldman's effect by c, or by the rho that c stands for. */
static double goldman(const struct rl_surface *s, rl_vec3 L, double c, bool by_c)
{
    const struct rl_effect *e = rl_effect_find("goldman");
    struct rl_material m = {0};
    double params[RL_EFFECT_PARAMS][4], rgb[3];
    double *value = rl_effect_give(&m, e);
    for (size_t i = 0; e->param[i].help; i++) {
        const char *key = e->param[i].key;
        double *v = value + rl_effect_value_of(e, i);
        if (e->param[i].kind == RL_EFFECT_COLOUR)
            v[0] = v[1] = v[2] = 0.5;
        else if (strcmp(key, "c") == 0 && by_c)
            *v = c;
        else if (strcmp(key, "rho-reflect") == 0 && !by_c)
            *v = 0.5 * (1.0 + c);
        else if (strcmp(key, "rho-transmit") == 0 && !by_c)
            *v = 0.5 * (1.0 - c);
    }
    e->pack(value, params);
    e->reflect(s, L, params, rgb);
    return rgb[0];
}

/* kappa as listed: nothing done where a sine is 0. */
static double kappa_listed(rl_vec3 n, rl_vec3 l, rl_vec3 e)
{
    rl_vec3 a = v3_cross(n, l), b = v3_cross(n, e);
    return v3_dot(a, b) / (v3_length(a) * v3_length(b));
}

/* N along l, e or both, either way. */
static int add_undefined(struct rl_record *r, struct rl_error *error)
{
    static const rl_vec3 axis = {0.0, 0.0, 1.0}, back = {0.0, 0.0, -1.0}, side = {0.6, 0.0, 0.8};
    const struct {
        rl_vec3 l, e;
    } row[] = {{axis, side}, {back, side}, {side, axis}, {side, back},
               {axis, axis}, {axis, back}, {back, axis}, {back, back}};
    size_t n = sizeof row / sizeof row[0], listed = 0, here = 0;
    for (size_t i = 0; i < n; i++) {
        listed += !isfinite(kappa_listed(axis, row[i].l, row[i].e));
        here += !isfinite(rl_fur_kappa(axis, row[i].l, row[i].e));
    }
    int status = add(r, "inputs", (double)n, error);
    if (status == RL_OK)
        status = add(r, "undefined_listing", (double)listed, error);
    return status == RL_OK ? add(r, "undefined", (double)here, error) : status;
}

int rl_fur_measure_terms(struct rl_record *r, struct rl_error *error)
{
    double wrong = 0.0, right = 0.0, off = 0.0;
    uint64_t at = 0, points = (uint64_t)rl_parameter_number(r->parameters, "points");
    for (uint64_t i = 0; i < points; i++) {
        rl_vec3 n = direction(&at), l = direction(&at), e = direction(&at);
        double psi = acos(fmin(fmax(v3_dot(n, l), -1.0), 1.0));
        double theta = acos(fmin(fmax(-v3_dot(n, e), -1.0), 1.0));
        double cosines = cos(psi) * cos(theta), sines = rl_fur_sine(n, l) * rl_fur_sine(n, e);
        wrong = fmax(wrong, fabs(cos(psi - theta) - (cosines - sines)));
        right = fmax(right, fabs(cos(psi - theta) - (cosines + sines)));
        const struct rl_surface s = {v3(0.0, 0.0, 0.0), n, e};
        double c = 2.0 * rl_random_uniform(SEED, at++) - 1.0;
        off = fmax(off, fabs(goldman(&s, l, c, true) - goldman(&s, l, c, false)));
    }
    int status = add(r, "wrong", wrong, error);
    if (status == RL_OK)
        status = add(r, "right", right, error);
    if (status == RL_OK)
        status = add(r, "direction", off, error);
    return status == RL_OK ? add_undefined(r, error) : status;
}

/* ---- The two faults of the highlight, one by one ---- */

enum { DEGREES = 181, MIDDLE = 90 };

static double lobe(bool plus, bool kept, double exponent, rl_vec3 n, rl_vec3 l, rl_vec3 e)
{
    double sines = rl_fur_sine(n, l) * rl_fur_sine(n, e), cosines = -v3_dot(n, l) * v3_dot(n, e);
    double cosine = plus ? cosines + sines : cosines - sines;
    return pow(fmin(kept ? fmax(cosine, 0.0) : fabs(cosine), 1.0), exponent);
}

int rl_fur_measure_form(struct rl_record *r, struct rl_error *error)
{
    double value[DEGREES], least = INFINITY;
    bool plus = rl_parameters_match(r->parameters, "sines=plus");
    bool kept = rl_parameters_match(r->parameters, "sign=kept");
    double exponent = rl_parameter_number(r->parameters, "exponent");
    const rl_vec3 l = rl_fur_light(rl_parameter_number(r->parameters, "beta")), e = {0.0, 0.0, 1.0};
    for (int i = 0; i < DEGREES; i++) {
        value[i] = lobe(plus, kept, exponent, rl_fur_light(i - MIDDLE), l, e);
        least = fmin(least, value[i]);
    }
    int status = add(r, "middle", value[MIDDLE], error);
    if (status == RL_OK)
        status = add(r, "rim", fmax(value[0], value[DEGREES - 1]), error);
    if (status == RL_OK)
        status = add(r, "least", least, error);
    if (status == RL_OK && rl_parameters_match(r->parameters, "line=on"))
        status = rl_record_series_add(r, "lobe", value, DEGREES, error);
    return status;
}
