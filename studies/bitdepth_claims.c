/* The claims that the study `bitdepth` judges. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "studies/bitdepth.h"
#include "studies/judging.h"
#include "studies/timing_arms.h"

/* "Almost no difference": this share of the noise of 4 random normals, and one step of an 8-bit frame buffer. */
static const double share_of_noise = 0.1;
static const double time_slack = 0.05;

/* At the largest N: bias is the same at each, but known best there. */
static const struct rl_metric *find(const struct rl_judging *j, const char *what, double rr,
                                    const char *metric)
{
    char pattern[256];
    double samples[RL_AXIS_MAX];
    snprintf(pattern, sizeof pattern, "%.200s rr=%g", what, rr);
    size_t n = rl_judging_axis(j, pattern, "samples", samples);
    if (n == 0)
        return NULL;
    snprintf(pattern, sizeof pattern, "%.180s rr=%g samples=%g", what, rr, samples[n - 1]);
    return rl_judging_metric(j, pattern, metric);
}

/* A metric that is small beside the noise and beside 1/255. Where there is no noise, nothing is said. */
struct smallness {
    const char *text, *figure, *what, *metric, *of_noise; /* of_noise NULL: not asked for */
};

/* Of the two the one that is larger beside what it may be decides: with both asked for the number is in parts of that. */
static struct rl_step small_step(double rr, const struct rl_metric *m, const struct rl_metric *of_noise)
{
    const double step = RL_STEP_OF_8_BITS;
    if (!of_noise)
        return (struct rl_step){rr, m->value, m->low, m->high, rl_verdict_at_most(m->low, m->high, step)};
    double low = fmax(m->low / step, of_noise->low / share_of_noise);
    double high = fmax(m->high / step, of_noise->high / share_of_noise);
    return (struct rl_step){rr, fmax(m->value / step, of_noise->value / share_of_noise), low, high,
                            rl_verdict_at_most(low, high, 1.0)};
}

static int claim_small(const struct rl_judging *j, const double *rr, size_t n, const struct smallness *s)
{
    struct rl_claim *c = rl_judging_claim(j, s->text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = s->figure;
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    char dark[96] = "";
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *m = find(j, s->what, rr[i], s->metric);
        const struct rl_metric *of_noise = s->of_noise ? find(j, s->what, rr[i], s->of_noise) : NULL;
        if (m && !rl_judging_lit(find(j, s->what, rr[i], "noise_4"))) {
            size_t used = strlen(dark);
            snprintf(dark + used, sizeof dark - used, "%s%g", used ? ", " : "", rr[i]);
        } else if (m && (!s->of_noise || (of_noise && !isnan(of_noise->value))))
            step[i] = small_step(rr[i], m, of_noise);
    }
    rl_judging_conclude(c, step, n, s->of_noise ? "of what is allowed" : "RMS");
    bool exact = n > 0;
    for (size_t i = 0; i < n; i++)
        exact = exact && step[i].high == 0.0;
    size_t used = strlen(c->note);
    if (exact && strcmp(s->figure, "formats") == 0)
        snprintf(c->note + used, sizeof c->note - used, "; %s", rl_judging_exactly);
    if (*dark)
        snprintf(c->note + used, sizeof c->note - used, "%s%s: R_r %s", used ? "; " : "", rl_judging_dark,
                 dark);
    return RL_OK;
}

static int claim_bits(const struct rl_judging *j, const double *rr, size_t n)
{
    static const struct smallness row[] = {
        {"paper: 8 bits (a step of 2/256) make almost no difference: bias below a tenth of the noise at N = "
         "4 "
         "and below 1/255",
         "normals", "series=normals normal_bits=8", "bias", "bias_of_noise"},
        {"ours: of this, the bias of 8-bit normals is below 1/255", "normals", "series=normals normal_bits=8",
         "bias", NULL},
        {"ours: 6 bits make almost no difference (bias below a tenth of the noise at N = 4 and below 1/255)",
         "normals", "series=normals normal_bits=6", "bias", "bias_of_noise"},
        {"ours: 10 bits make almost no difference (bias below a tenth of the noise at N = 4 and below 1/255)",
         "normals", "series=normals normal_bits=10", "bias", "bias_of_noise"},
        {"ours: 12 bits make almost no difference (bias below a tenth of the noise at N = 4 and below 1/255)",
         "normals", "series=normals normal_bits=12", "bias", "bias_of_noise"},
        {"ours: 16 bits make almost no difference (bias below a tenth of the noise at N = 4 and below 1/255)",
         "normals", "series=normals normal_bits=16", "bias", "bias_of_noise"},
        {"ours: halves make almost no difference (bias below a tenth of the noise at N = 4 and below 1/255)",
         "normals", "series=normals normal_bits=half", "bias", "bias_of_noise"},
        {"ours: 13 regular normals rounded to 8 bits change the picture by less than 1/255", "regular",
         "series=regular normal_bits=8", "change", NULL},
        {"ours: 13 regular normals rounded to 10 bits change the picture by less than 1/255", "regular",
         "series=regular normal_bits=10", "change", NULL},
        {"ours: an environment map of 8 bits is enough: it changes the picture by less than a tenth of the "
         "noise at N = 4 and 1/255",
         "formats", "series=environment env_format=rgba8", "change", "change_of_noise"},
        {"ours: an environment map r11g11b10f changes the picture by less than a tenth of the noise at N = 4 "
         "and 1/255",
         "formats", "series=environment env_format=r11g11b10f", "change", "change_of_noise"},
        {"ours: a frame buffer of 8 bits is enough: it changes the picture by less than a tenth of the "
         "noise "
         "at N = 4 and 1/255",
         "formats", "series=frame frame_format=rgba8", "change", "change_of_noise"},
        {"ours: a frame buffer r11g11b10f changes the picture by less than a tenth of the noise at N = 4 and "
         "1/255",
         "formats", "series=frame frame_format=r11g11b10f", "change", "change_of_noise"},
    };
    int status = RL_OK;
    for (size_t k = 0; k < sizeof row / sizeof row[0] && status == RL_OK; k++)
        status = claim_small(j, rr, n, &row[k]);
    return status;
}

/* The same 8 bits: bias of random against the change that a fixed pattern suffers. */
static int claim_regular(const struct rl_judging *j, const double *rr, size_t n)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: 8 bits harm random normals less than a fixed pattern of "
                                             "13 (ratio of their bias to its change)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "regular";
    struct rl_step step[RL_AXIS_MAX];
    rl_judging_steps(step, rr, n);
    for (size_t i = 0; i < n; i++) {
        const struct rl_metric *random = find(j, "series=normals normal_bits=8", rr[i], "bias");
        const struct rl_metric *regular = find(j, "series=regular normal_bits=8", rr[i], "change");
        if (!regular || !random || !(regular->value > 0.0) ||
            !rl_judging_lit(find(j, "series=normals normal_bits=8", rr[i], "noise_4")))
            continue;
        struct rl_claim ratio = {0};
        rl_judging_ratio(&ratio, random, regular, "1");
        step[i] = (struct rl_step){rr[i], ratio.value, ratio.low, ratio.high,
                                   rl_verdict_at_most(ratio.low, ratio.high, 1.0)};
    }
    rl_judging_conclude(c, step, n, "times");
    return RL_OK;
}

/* A map that has other bits than it is said to have would change the picture as if it lay elsewhere between its neighbours: each bit
 * changes it by sqrt(2) to 2 times (by the chance that a normal finds another texel, or by the bias). */
static int claim_rounding(const struct rl_judging *j, const double *rr, size_t n)
{
    static const double one_bit = 1.4142135623730951;
    struct rl_claim *c =
        rl_judging_claim(j, "ours: 8 bits are 8 bits: they change the picture by less than sqrt(2) times "
                            "the geometric mean of 6 and 10 bits, that is, by less than with 7");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "rounding";
    double at = rl_central_rr(rr, n);
    const struct rl_metric *six = find(j, "series=normals normal_bits=6", at, "change"),
                           *eight = find(j, "series=normals normal_bits=8", at, "change"),
                           *ten = find(j, "series=normals normal_bits=10", at, "change");
    if (!six || !eight || !ten || !(six->value * ten->value > 0.0))
        return RL_OK;
    double least = sqrt(six->low * ten->low);
    rl_claim_value(c, eight->value / sqrt(six->value * ten->value), eight->low / sqrt(six->high * ten->high),
                   least > 0.0 ? eight->high / least : INFINITY, "times");
    snprintf(c->note, sizeof c->note, "at R_r %g; RMS change with 6, 8, 10 bits: %.3g, %.3g, %.3g", at,
             six->value, eight->value, ten->value);
    c->verdict = rl_verdict_at_most(c->low, c->high, one_bit);
    return RL_OK;
}

static const struct rl_metric *time_ratio(const struct rl_judging *j, const char *arm)
{
    char pattern[64];
    snprintf(pattern, sizeof pattern, "series=time arm=%.30s", arm);
    return rl_judging_metric(j, pattern, "time_to_8");
}

/* A difference smaller than that of two arms of the same work decides nothing. */
static int claim_time(const struct rl_judging *j)
{
    static const struct {
        const char *text, *arm;
    } row[] = {
        {"ours: normal maps of 10 bits cost at most 5 % more frame time than those of 8", "10"},
        {"ours: normal maps of 16 bits cost at most 5 % more frame time than those of 8", "16"},
        {"ours: normal maps of floats cost at most 5 % more frame time than those of 8 bits", "float"},
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        struct rl_claim *c = rl_judging_claim(j, row[k].text);
        if (!c)
            return RL_ERR_SYSTEM;
        c->figure = "time";
        double noise = rl_arms_noise(time_ratio(j, "8-again"));
        const struct rl_metric *t = time_ratio(j, row[k].arm);
        if (!t)
            continue;
        rl_claim_value(c, t->value, t->low, t->high, "times");
        snprintf(c->note, sizeof c->note, "4 random normals, paired by round; 8 bits against itself: %.2g",
                 noise);
        c->verdict = rl_arms_at_most(t, noise, 1.0 + time_slack);
    }
    return RL_OK;
}

int rl_bitdepth_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        struct rl_judging j = {run, scene, claims, error};
        double rr[RL_AXIS_MAX];
        size_t n = rl_judging_axis(&j, "series=normals", "rr", rr);
        status = claim_bits(&j, rr, n);
        if (status == RL_OK)
            status = claim_regular(&j, rr, n);
        if (status == RL_OK)
            status = claim_rounding(&j, rr, n);
        if (status == RL_OK)
            status = claim_time(&j);
    }
    return status;
}
