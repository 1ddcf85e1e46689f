/* What the study `fur` says of the models: the glow, its causes, and the listing's other faults. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/fur.h"

static struct rl_claim *begin(const struct rl_judging *j, const char *figure, const char *text)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (c)
        c->figure = figure;
    return c;
}

static void note(struct rl_claim *c, const char *what, double value)
{
    size_t used = strlen(c->note);
    if (!isnan(value))
        snprintf(c->note + used, sizeof c->note - used, "%s%s: %.3g", used ? "; " : "", what, value);
}

/* ---- Rows ---- */

static const struct rl_metric *term(const struct rl_judging *j, const char *metric)
{
    return rl_judging_metric(j, "series=terms", metric);
}

static const struct rl_metric *form(const struct rl_judging *j, double beta, const char *kind,
                                    const char *metric)
{
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=form beta=%g %s", beta, kind);
    return rl_judging_metric(j, pattern, metric);
}

static const struct rl_metric *profile(const struct rl_judging *j, double beta, const char *effect,
                                       const char *metric)
{
    char pattern[96];
    snprintf(pattern, sizeof pattern, "series=profile beta=%g effect=%s", beta, effect);
    return rl_judging_metric(j, pattern, metric);
}

/* ---- The glow ---- */

static int claim_identity(const struct rl_judging *j)
{
    struct rl_claim *c = begin(j, "causes",
                               "ours: cos(psi - theta) is cos psi cos theta - sin psi sin theta, as listed "
                               "(largest difference, at most 1e-9)");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *wrong = term(j, "wrong"), *right = term(j, "right");
    if (wrong)
        rl_claim_value(c, wrong->value, wrong->low, wrong->high, "1");
    c->verdict = rl_verdict_at_most(c->low, c->high, 1e-9);
    note(c, "with + in place of -", right ? right->value : NAN);
    return RL_OK;
}

/* What the listing adds to the middle, against what closed forms say; in units of the highlight's most. */
struct glow {
    double value, room, closed;
};

static bool glow_at(struct glow *g, const struct rl_judging *j, double beta)
{
    const struct rl_metric *listed = profile(j, beta, "kajiya-printed", "middle");
    const struct rl_metric *right = profile(j, beta, "kajiya", "middle");
    char pattern[64];
    snprintf(pattern, sizeof pattern, "series=profile beta=%g effect=kajiya", beta);
    const struct rl_record *r = rl_run_find(j->run, j->scene, pattern);
    if (!listed || !right || !r)
        return false;
    double most = RL_FUR_IRRADIANCE * RL_FUR_SPECULAR,
           exponent = rl_parameter_number(r->parameters, "exponent");
    double cosine = cos(beta * RL_PI / 180.0);
    g->value = (listed->value - right->value) / most;
    g->room = (listed->high - listed->low + right->high - right->low) / (2.0 * most);
    g->closed = pow(fabs(cosine), exponent) - pow(fmax(-cosine, 0.0), exponent);
    return true;
}

static int claim_glow(const struct rl_judging *j)
{
    struct glow g;
    struct rl_claim *c =
        begin(j, "kajiya",
              "ours: lit from the eye, Kajiya's fur as listed glows in the middle of the ball (its radiance "
              "there less the corrected one's, over the highlight's most; at least a half)");
    if (!c)
        return RL_ERR_SYSTEM;
    if (glow_at(&g, j, 0.0)) {
        rl_claim_value(c, g.value, g.value - g.room, g.value + g.room, "of k_s E");
        note(c, "in closed form", g.closed);
    }
    c->verdict = rl_verdict_at_least(c->low, c->high, 0.5);
    return RL_OK;
}

static int claim_closed_glow(const struct rl_judging *j)
{
    double beta[RL_AXIS_MAX], most = RL_FUR_IRRADIANCE * RL_FUR_SPECULAR, worst = NAN;
    struct rl_claim *c =
        begin(j, "glow",
              "ours: the glow is k_s E cos^p beta, for beta below 90 degrees between light and eye, and 0 "
              "beyond (largest difference over the angles, at most 1/255)");
    if (!c)
        return RL_ERR_SYSTEM;
    size_t n = rl_judging_axis(j, "series=profile", "beta", beta);
    for (size_t i = 0; i < n; i++) {
        struct glow g;
        if (!glow_at(&g, j, beta[i]))
            continue;
        double off = most * fabs(g.value - g.closed), room = most * g.room;
        enum rl_verdict v = rl_verdict_at_most(fmax(off - room, 0.0), off + room, RL_STEP_OF_8_BITS);
        if (isnan(worst))
            c->verdict = RL_VERDICT_HOLDS;
        if (rl_judging_worse(c, v, off + room, &worst)) {
            rl_claim_value(c, off, fmax(off - room, 0.0), off + room, "of full scale");
            c->note[0] = '\0';
            note(c, "at beta in degrees", beta[i]);
        }
    }
    return RL_OK;
}

/* Either fault put right alone: what stays of the glow, at the angle where most, or least, of it does. */
static const struct {
    const char *kind, *text;
    bool stays;
    double bound;
} causes[] = {
    {"sines=plus sign=lost",
     "ours: the wrong sign of the sines does not make the glow: with that put right alone all of it stays "
     "(middle over that as listed, at least 99 % at all angles below 90 degrees)",
     true, 0.99},
    {"sines=minus sign=kept",
     "ours: the lost sign of the cosine makes the glow: with that kept alone nothing of it stays (middle "
     "over that as listed, at most 1 % at all angles below 90 degrees)",
     false, 0.01},
};

static int claim_causes(const struct rl_judging *j)
{
    for (size_t k = 0; k < sizeof causes / sizeof causes[0]; k++) {
        double beta[RL_AXIS_MAX], worst = NAN;
        struct rl_claim *c = begin(j, "causes", causes[k].text);
        if (!c)
            return RL_ERR_SYSTEM;
        size_t n = rl_judging_axis(j, "series=form", "beta", beta);
        for (size_t i = 0; i < n && beta[i] < 90.0; i++) {
            const struct rl_metric *listed = form(j, beta[i], "sines=minus sign=lost", "middle");
            const struct rl_metric *one = form(j, beta[i], causes[k].kind, "middle");
            if (!listed || !one || !(listed->value > 0.0))
                continue;
            double x = one->value / listed->value;
            enum rl_verdict v = causes[k].stays ? rl_verdict_at_least(x, x, causes[k].bound)
                                                : rl_verdict_at_most(x, x, causes[k].bound);
            if (isnan(worst))
                c->verdict = RL_VERDICT_HOLDS;
            if (rl_judging_worse(c, v, causes[k].stays ? -x : x, &worst))
                rl_claim_value(c, x, x, x, "of the glow");
        }
    }
    return RL_OK;
}

static int claim_everywhere(const struct rl_judging *j)
{
    struct rl_claim *c =
        begin(j, "causes",
              "ours: what the wrong sign of the sines does is to light all of a ball lit from the eye (least "
              "highlight along its middle column, at least a half)");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *least = form(j, 0.0, "sines=minus sign=lost", "least");
    const struct rl_metric *right = form(j, 0.0, "sines=plus sign=lost", "least");
    if (least)
        rl_claim_value(c, least->value, least->low, least->high, "of k_s E");
    c->verdict = rl_verdict_at_least(c->low, c->high, 0.5);
    note(c, "with the sines' sign right", right ? right->value : NAN);
    return RL_OK;
}

static int claim_rim(const struct rl_judging *j)
{
    struct rl_claim *c =
        begin(j, "kajiya",
              "ours: corrected, Kajiya's fur is bright at the rim alone, lit from the eye (radiance in the "
              "middle over that at the rim, at most 5 %)");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *middle = profile(j, 0.0, "kajiya", "middle"),
                           *rim = profile(j, 0.0, "kajiya", "rim");
    const struct rl_metric *listed = profile(j, 0.0, "kajiya-printed", "middle"),
                           *listed_rim = profile(j, 0.0, "kajiya-printed", "rim");
    if (middle && rim)
        rl_judging_ratio(c, middle, rim, "of the rim");
    c->verdict = rl_verdict_at_most(c->low, c->high, 0.05);
    if (listed && listed_rim)
        note(c, "as listed", listed->value / listed_rim->value);
    return RL_OK;
}

static int claim_pictures(const struct rl_judging *j)
{
    double worst = NAN;
    struct rl_claim *c = begin(j, "goldman",
                               "ours: pictures of all models are what the closed forms say, at every angle "
                               "between light and eye (largest difference, at most 1/255)");
    if (!c)
        return RL_ERR_SYSTEM;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "series=profile"));) {
        char effect[RL_NAME_MAX];
        const struct rl_metric *off = rl_record_metric(r, "off");
        if (!off)
            continue;
        enum rl_verdict v = rl_verdict_at_most(off->low, off->high, RL_STEP_OF_8_BITS);
        if (isnan(worst))
            c->verdict = RL_VERDICT_HOLDS;
        if (!rl_judging_worse(c, v, off->value, &worst))
            continue;
        rl_claim_value(c, off->value, off->low, off->high, "of full scale");
        rl_parameter(r->parameters, "effect", effect, sizeof effect);
        snprintf(c->note, sizeof c->note, "of %s at beta = %g degrees", effect,
                 rl_parameter_number(r->parameters, "beta"));
    }
    return RL_OK;
}

/* ---- Goldman and Lengyel ---- */

static int claim_direction(const struct rl_judging *j)
{
    struct rl_claim *c =
        begin(j, "goldman",
              "ours: f_dir = (1 + c kappa)/2 is the general form with rho_reflect = (1 + c)/2 and "
              "rho_transmit = (1 - c)/2 (largest difference of radiance, at most 1e-9)");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *off = term(j, "direction");
    if (off)
        rl_claim_value(c, off->value, off->low, off->high, "1");
    c->verdict = rl_verdict_at_most(c->low, c->high, 1e-9);
    return RL_OK;
}

/* kappa is 1 about the middle where the light is behind the eye. */
static int claim_unclamped(const struct rl_judging *j)
{
    struct rl_claim *c = begin(
        j, "goldman",
        "ours: Lambert's term unclamped makes the glow of Goldman's fur three times as bright, lit from "
        "the eye (middle over Kajiya's as listed and f_dir, 3 to within 0.1)");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *goldman = profile(j, 0.0, "goldman-printed", "middle");
    const struct rl_metric *kajiya = profile(j, 0.0, "kajiya-printed", "middle");
    if (goldman && kajiya) {
        rl_judging_ratio(c, goldman, kajiya, "times");
        double f_dir = 0.5 * (1.0 + RL_FUR_C);
        rl_claim_value(c, c->value / f_dir, c->low / f_dir, c->high / f_dir, "times");
    }
    c->verdict = rl_verdict_equals(c->low, c->high, 3.0, 0.1);
    return RL_OK;
}

/* The least radiance over all angles between light and eye. */
static int claim_least(const struct rl_judging *j, const char *effect, const char *text, bool negative)
{
    double beta[RL_AXIS_MAX];
    struct rl_claim *c = begin(j, "goldman", text);
    if (!c)
        return RL_ERR_SYSTEM;
    size_t n = rl_judging_axis(j, "series=profile", "beta", beta);
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *least = profile(j, beta[i], effect, "least");
        if (!least || least->value >= c->value)
            continue;
        rl_claim_value(c, least->value, least->low, least->high, "of full scale");
        c->note[0] = '\0';
        note(c, "at beta in degrees", beta[i]);
    }
    c->verdict = negative ? rl_verdict_at_most(c->low, c->high, -RL_STEP_OF_8_BITS)
                          : rl_verdict_at_least(c->low, c->high, 0.0);
    return RL_OK;
}

static int claim_lengyel(const struct rl_judging *j)
{
    struct rl_claim *c = begin(j, "glow",
                               "ours: Lengyel's fur does not glow in the middle, lit from the eye (radiance "
                               "there, at most 1/255)");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *middle = profile(j, 0.0, "lengyel", "middle");
    if (middle)
        rl_claim_value(c, middle->value, middle->low, middle->high, "of full scale");
    c->verdict = rl_verdict_at_most(c->low, c->high, RL_STEP_OF_8_BITS);
    return RL_OK;
}

static int claim_undefined(const struct rl_judging *j)
{
    struct rl_claim *c = begin(j, "goldman",
                               "ours: the listed kappa is a number wherever N points (inputs with N along l, "
                               "e or both for which it is none: 0)");
    if (!c)
        return RL_ERR_SYSTEM;
    const struct rl_metric *listed = term(j, "undefined_listing"), *here = term(j, "undefined");
    const struct rl_metric *inputs = term(j, "inputs");
    if (listed)
        rl_claim_value(c, listed->value, listed->low, listed->high, "inputs");
    c->verdict = rl_verdict_at_most(c->low, c->high, 0.0);
    note(c, "of", inputs ? inputs->value : NAN);
    note(c, "of the effect goldman", here ? here->value : NAN);
    return RL_OK;
}

/* ---- All ---- */

static int judge_models(const struct rl_judging *j)
{
    static int (*const claim[])(const struct rl_judging *) = {
        claim_glow,     claim_closed_glow, claim_causes,  claim_everywhere, claim_rim,
        claim_identity, claim_pictures,    claim_lengyel, claim_direction,  claim_unclamped,
    };
    int status = RL_OK;
    for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
        status = claim[k](j);
    if (status == RL_OK)
        status = claim_least(j, "goldman-printed",
                             "ours: unclamped, it takes light away where light comes from below the surface "
                             "(least radiance over all angles, below -1/255)",
                             true);
    if (status == RL_OK)
        status = claim_least(j, "goldman",
                             "ours: Goldman's fur as it is here never takes light away (least radiance over "
                             "all angles, at least 0)",
                             false);
    return status == RL_OK ? claim_undefined(j) : status;
}

int rl_fur_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; (scene = rl_run_scene(run, i)) && status == RL_OK; i++) {
        const struct rl_judging j = {run, scene, claims, error};
        if (strcmp(scene, RL_NO_SCENE) == 0)
            status = judge_models(&j);
        if (status == RL_OK)
            status = rl_fur_judge_costs(&j);
    }
    return status;
}
