/* The claims that the study `frame` judges. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/frame.h"
#include "studies/judging.h"

/* A claim with "R_r 30" between both parts. */
static struct rl_claim *begin_claim_at(const struct rl_judging *j, const char *before, double rr,
                                       const char *after)
{
    char text[256];
    snprintf(text, sizeof text, "%sR_r %g%s", before, rr, after);
    return rl_judging_claim(j, text);
}

/* "; outside: 0.031" */
static void append(char *note, size_t size, const char *what, double value)
{
    size_t used = strlen(note);
    snprintf(note + used, size - used, "%s%s: %.3g", used ? "; " : "", what, value);
}

/* The R_r where single figures are taken: the measured one that is nearest to 30, where the highlight shows the light's shape. */
static double central_rr(const struct rl_judging *j, const char *series)
{
    double rr[RL_AXIS_MAX];
    return rl_central_rr(rr, rl_judging_axis(j, series, "rr", rr));
}

/* A metric of the series at every R_r goes into the note, that at the central R_r is the claim's number. */
static const struct rl_metric *over_rr(struct rl_claim *c, const struct rl_judging *j, const char *series,
                                       const char *metric, const char *unit)
{
    const struct rl_metric *central = NULL;
    double middle = central_rr(j, series);
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, series));) {
        const struct rl_metric *m = rl_record_metric(r, metric);
        double rr = rl_parameter_number(r->parameters, "rr");
        if (!m)
            continue;
        rl_judging_note(c, rr, m->value);
        if (rr != middle)
            continue;
        central = m;
        rl_claim_value(c, m->value, m->low, m->high, unit);
    }
    return central;
}

static int claim_rotation(const struct rl_judging *j)
{
    struct rl_claim *c =
        rl_judging_claim(j, "paper: the printed frame is a rotation: lobes are as wide at every normal (mean "
                            "width over the sphere, 1 to within 1 %)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "map";
    if (over_rr(c, j, "series=lobe", "width", "times"))
        c->verdict = rl_verdict_equals(c->low, c->high, 1.0, 0.01);
    return RL_OK;
}

/* The R_r farthest from the formula speaks for all. */
static int claim_formula(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: it narrows the lobe as tan(delta') = l tan(delta), l = sqrt(n_y^2 + n_z^2) "
           "(measured over expected width, 1 to within 1 %)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "width";
    over_rr(c, j, "series=lobe", "against_formula", "times");
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "series=lobe"));) {
        const struct rl_metric *m = rl_record_metric(r, "against_formula");
        if (m && !(fabs(m->value - 1.0) <= fabs(c->value - 1.0)))
            rl_claim_value(c, m->value, m->low, m->high, "times");
    }
    c->verdict = rl_verdict_equals(c->low, c->high, 1.0, 0.01);
    return RL_OK;
}

static int claim_half(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "paper: the printed frame serves: on no more than 1 % of the sphere has a lobe less "
           "than half its width");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "map";
    if (!over_rr(c, j, "series=lobe", "half", "of the sphere"))
        return RL_OK;
    append(c->note, sizeof c->note, "of small angles, by the formula", 1.0 - sqrt(0.75));
    c->verdict = rl_verdict_at_most(c->low, c->high, 0.01);
    return RL_OK;
}

/* A claim about every place of the light at the central R_r: the worst is its number. */
static int claim_light(const struct rl_judging *j, const char *before, const char *after, const char *metric,
                       double bound)
{
    double rr = central_rr(j, "series=light");
    char pattern[64];
    struct rl_claim *c = begin_claim_at(j, before, rr, after);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "highlight";
    snprintf(pattern, sizeof pattern, "series=light rr=%g", rr);
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, pattern));) {
        const struct rl_metric *m = rl_record_metric(r, metric);
        char what[RL_NAME_MAX];
        if (!m || !rl_parameter(r->parameters, "place", what, sizeof what))
            continue;
        append(c->note, sizeof c->note, what, m->value);
        if (!(m->value <= c->value))
            rl_claim_value(c, m->value, m->low, m->high, "of full scale");
    }
    c->verdict = rl_verdict_at_most(c->low, c->high, bound);
    return RL_OK;
}

static int claim_scene(const struct rl_judging *j)
{
    static const struct {
        const char *before, *after, *metric, *unit;
    } row[] = {
        {"paper: the printed frame serves: it moves the whole picture at ", " by at most 1/255 (RMSE)",
         "rmse", "RMSE"},
        {"paper: the printed frame serves: it moves no pixel of the picture at ", " by more than 1/255",
         "max", "of full scale"},
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        struct rl_claim *c = begin_claim_at(j, row[k].before, central_rr(j, "series=scene"), row[k].after);
        if (!c)
            return RL_ERR_SYSTEM;
        c->figure = "scene";
        if (over_rr(c, j, "series=scene", row[k].metric, row[k].unit))
            c->verdict = rl_verdict_at_most(c->low, c->high, RL_STEP_OF_8_BITS);
    }
    return RL_OK;
}

static int judge_alone(const struct rl_judging *j)
{
    int (*const claim[])(const struct rl_judging *) = {claim_rotation, claim_formula, claim_half};
    int status = RL_OK;
    for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
        status = claim[k](j);
    if (status == RL_OK)
        status = claim_light(j, "paper: the printed frame serves: it moves a highlight of ",
                             " by at most 1/255 (RMS over the "
                             "sphere, worst place of the light)",
                             "rms", RL_STEP_OF_8_BITS);
    if (status == RL_OK)
        status = claim_light(
            j,
            "ours: in an orthonormal frame a highlight that turns with the normal is the same everywhere (to "
            "within 1e-5, ",
            ")", "spread", 1e-5);
    return status;
}

int rl_frame_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        const struct rl_judging j = {run, scene, claims, error};
        status = strcmp(scene, RL_NO_SCENE) == 0 ? judge_alone(&j) : claim_scene(&j);
    }
    return status;
}
