/* The claims that the study `roughness` judges, at every R_r that was measured. */
#include <math.h>
#include <stdio.h>

#include "studies/judging.h"
#include "studies/roughness.h"

static const struct rl_metric *find(const struct rl_judging *j, const char *what, double rr,
                                    const char *metric)
{
    char pattern[256];
    snprintf(pattern, sizeof pattern, "%.200s rr=%g", what, rr);
    return rl_judging_metric(j, pattern, metric);
}

/* Is a metric at most one step of an 8-bit frame buffer at every R_r? */
static int claim_at_most(const struct rl_judging *j, const double *rr, size_t n, const char *text,
                         const char *what, const char *metric, const char *figure)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = figure;
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *m = find(j, what, rr[i], metric);
        if (!m)
            continue;
        step[i] = (struct rl_step){rr[i], m->value, m->low, m->high,
                                   rl_verdict_at_most(m->low, m->high, RL_STEP_OF_8_BITS)};
    }
    rl_judging_conclude(c, step, n, "RMSE");
    return RL_OK;
}

static int claim_enough(const struct rl_judging *j, const double *rr, size_t n)
{
    static const struct {
        const char *text, *what, *metric, *figure;
    } row[] = {
        {"paper: 4 random normals a pixel suffice at every R_r: RMSE at most 1/255 of full scale",
         "series=methods setting=paper method=random samples=4", "rmse", "error"},
        {"ours: 13 regular normals a pixel suffice at every R_r: RMSE at most 1/255",
         "series=methods setting=paper method=regular samples=13", "rmse", "error"},
        {"ours: 16 random normals a pixel suffice at every R_r: RMSE at most 1/255",
         "series=methods setting=paper method=random samples=16", "rmse", "error"},
        {"ours: but for parallax (lights seen from the object's centre) 4 random normals suffice at every "
         "R_r: RMSE at most 1/255",
         "series=methods setting=paper method=random samples=4", "rmse_centre", "centre"},
        {"ours: what no number of normals removes (the floor, parallax included) stays at most 1/255 at "
         "every R_r",
         "series=needed setting=paper", "floor", "split"},
        {"ours: the exhaustive sum over the texels of a small map is right but for parallax: RMSE at most "
         "1/255 at every R_r",
         "series=methods setting=paper method=exhaustive", "rmse_centre", "centre"},
        {"ours: with float normals and a large map nothing but parallax stays: the floor without it is at "
         "most 1/255 at "
         "every R_r",
         "series=needed setting=fine", "floor_centre", "split"},
    };
    int status = RL_OK;
    for (size_t k = 0; k < sizeof row / sizeof row[0] && status == RL_OK; k++)
        status = claim_at_most(j, rr, n, row[k].text, row[k].what, row[k].metric, row[k].figure);
    return status;
}

/* Some N suffices where even the upper end of its interval is finite, none where even the lower end is not. */
static enum rl_verdict some_suffice(const struct rl_metric *m)
{
    if (isfinite(m->high))
        return RL_VERDICT_HOLDS;
    return isinf(m->low) ? RL_VERDICT_FAILS : RL_VERDICT_INCONCLUSIVE;
}

static int claim_needed(const struct rl_judging *j, const double *rr, size_t n)
{
    static const struct {
        const char *text, *what, *metric, *floor;
    } row[] = {
        {"ours: with the paper's settings some number of random normals brings RMSE to 1/255 at every R_r",
         "series=needed setting=paper", "needed", "floor"},
        {"ours: the same but for parallax: against lights seen from the object's centre some number does",
         "series=needed setting=paper", "needed_centre", "floor_centre"},
        {"ours: but for parallax, with float normals and a large map some number does",
         "series=needed setting=fine", "needed_centre", "floor_centre"},
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        struct rl_claim *c = rl_judging_claim(j, row[k].text);
        if (!c)
            return RL_ERR_SYSTEM;
        c->figure = "needed";
        struct rl_step step[RL_AXIS_MAX];
        rl_judging_steps(step, rr, n);
        for (size_t i = 0; i < n; i++) {
            const struct rl_metric *m = find(j, row[k].what, rr[i], row[k].metric);
            if (!m)
                continue;
            step[i] = (struct rl_step){rr[i], m->value, m->low, m->high, some_suffice(m)};
        }
        rl_judging_conclude(c, step, n, "normals a pixel");
        if (!isinf(c->value))
            continue;
        for (size_t i = 0; i < n; i++)
            rl_judging_instead(&step[i], find(j, row[k].what, rr[i], row[k].floor));
        rl_judging_conclude_again(c, step, n, "RMSE, the floor");
    }
    return RL_OK;
}

/* The counts are extrapolated: N x variance must be the same at the smallest and the largest N. The R_r where it is farthest from that
 * speaks for all. */
static int claim_extrapolation(const struct rl_judging *j, const double *rr, size_t n)
{
    static const char what[] = "series=methods setting=paper method=random";
    struct rl_claim *c = rl_judging_claim(
        j, "ours: noise falls as 1/N, which the counts rest on: N x variance at the largest N is that at the "
           "smallest (ratio 1 to within a quarter, at every R_r)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "split";
    double N[RL_AXIS_MAX], worst = NAN;
    size_t n_samples = rl_judging_axis(j, what, "samples", N);
    for (size_t i = 0; i < n && n_samples > 1; i++) {
        char few[160], many[160];
        snprintf(few, sizeof few, "%s samples=%g", what, N[0]);
        snprintf(many, sizeof many, "%s samples=%g", what, N[n_samples - 1]);
        const struct rl_metric *a = find(j, few, rr[i], "variance"), *b = find(j, many, rr[i], "variance");
        if (!a || !b)
            continue;
        double scale = N[n_samples - 1] / N[0];
        struct rl_claim ratio = {0};
        rl_judging_ratio(&ratio, b, a, "1");
        rl_judging_note(c, rr[i], scale * ratio.value);
        enum rl_verdict verdict = rl_verdict_equals(scale * ratio.low, scale * ratio.high, 1.0, 0.25);
        if (rl_judging_worse(c, verdict, fabs(log(scale * ratio.value)), &worst))
            rl_claim_value(c, scale * ratio.value, scale * ratio.low, scale * ratio.high, "times");
    }
    return RL_OK;
}

static int claim_against(const struct rl_judging *j, const double *rr, size_t n)
{
    static const struct {
        const char *text, *than;
    } row[] = {
        {"paper: shaped highlights are worth it: 4 random normals have less error than plain at every R_r "
         "(ratio of RMSE)",
         "series=methods setting=paper method=plain"},
        {"paper: 4 random normals have no more error than 13 regular ones at every R_r (ratio of RMSE)",
         "series=methods setting=paper method=regular samples=13"},
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        struct rl_claim *c = rl_judging_claim(j, row[k].text);
        if (!c)
            return RL_ERR_SYSTEM;
        c->figure = "error";
        struct rl_step step[RL_AXIS_MAX];
        rl_judging_steps(step, rr, n);
        for (size_t i = 0; i < n; i++) {
            const struct rl_metric *a =
                find(j, "series=methods setting=paper method=random samples=4", rr[i], "rmse");
            const struct rl_metric *b = find(j, row[k].than, rr[i], "rmse");
            if (!a || !b)
                continue;
            struct rl_claim ratio = {0};
            rl_judging_ratio(&ratio, a, b, "1");
            step[i] = (struct rl_step){rr[i], ratio.value, ratio.low, ratio.high,
                                       rl_verdict_at_most(ratio.low, ratio.high, 1.0)};
        }
        rl_judging_conclude(c, step, n, "1");
    }
    return RL_OK;
}

/* The roughest lobe is the widest and reaches the horizon, where G counts: without G it would be brighter everywhere. */
static int claim_attenuation(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: attenuation is as the reference has it: at the roughest R_r, with float "
                            "normals and a large map, the floor but for parallax is at most 1/510");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "split";
    const struct rl_metric *m = n ? find(j, "series=needed setting=fine", rr[0], "floor_centre") : NULL;
    if (!m)
        return RL_OK;
    rl_claim_value(c, m->value, m->low, m->high, "RMSE");
    snprintf(c->note, sizeof c->note, "at R_r %g", rr[0]);
    c->verdict = rl_verdict_at_most(m->low, m->high, 0.5 * RL_STEP_OF_8_BITS);
    return RL_OK;
}

int rl_roughness_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        struct rl_judging j = {run, scene, claims, error};
        double rr[RL_AXIS_MAX];
        size_t n = rl_judging_axis(&j, "series=methods setting=paper", "rr", rr);
        int (*const claim[])(const struct rl_judging *, const double *, size_t) = {
            claim_enough, claim_needed, claim_extrapolation, claim_against, claim_attenuation};
        for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
            status = claim[k](&j, rr, n);
    }
    return status;
}
