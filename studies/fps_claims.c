/* The claims that the study `fps` judges on Table 1, from raw frame times paired by round. */
#include <math.h>
#include <stdio.h>

#include "measure/statistics.h"
#include "studies/fps.h"
#include "studies/judging.h"

static const struct rl_series *frames(const struct rl_judging *j, const char *arm)
{
    char pattern[64];
    snprintf(pattern, sizeof pattern, "series=table1 arm=%s", arm);
    const struct rl_record *r = rl_run_find(j->run, j->scene, pattern);
    return r ? rl_record_series(r, "frame_ms") : NULL;
}

/* How many times as long the arm `a` takes as the arm `b`; NaN if either was not measured. */
static struct rl_interval ratio(const struct rl_judging *j, const char *a, const char *b)
{
    const struct rl_series *x = frames(j, a), *y = frames(j, b);
    if (!x || !y)
        return (struct rl_interval){NAN, NAN, NAN};
    return rl_interval_from_0(rl_ratio_interval(x->value, y->value, x->n < y->n ? x->n : y->n, 0.95));
}

/* A difference smaller than that of two equal arms says nothing. */
static enum rl_verdict faster(struct rl_interval times, double noise_floor)
{
    if (times.low > 1.0 + noise_floor)
        return RL_VERDICT_HOLDS;
    return times.high < 1.0 - noise_floor ? RL_VERDICT_FAILS : RL_VERDICT_INCONCLUSIVE;
}

/* `noise_floor`: the largest relative difference between two arms of the same work that is still chance. */
static int claim_random_faster(const struct rl_judging *j, double noise_floor)
{
    struct rl_claim *c = rl_judging_claim(
        j, "paper: 4 random normals are faster than 13 regular ones (paper: 38/28 = 1.36 times)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "rate";
    struct rl_interval times = ratio(j, "regular-13", "random-4");
    rl_claim_value(c, times.value, times.low, times.high, "times");
    snprintf(c->note, sizeof c->note,
             "paired by round; noise floor of the A/A arms %.2g; the paper's ratio %.3g", noise_floor,
             RL_PAPER_RANDOM_FPS / RL_PAPER_REGULAR_FPS);
    c->verdict = faster(times, noise_floor);
    return RL_OK;
}

static int claim_plain(const struct rl_judging *j, double noise_floor)
{
    struct rl_claim *c = rl_judging_claim(
        j, "paper: on this renderer too the light's shape costs a factor of 530/38 = 13.9 in speed, "
           "plain against random 4 (to within a quarter)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "rate";
    double expected = RL_PAPER_PLAIN_FPS / RL_PAPER_RANDOM_FPS;
    struct rl_interval times = ratio(j, "random-4", "plain");
    rl_claim_value(c, times.value, times.low, times.high, "times");
    snprintf(c->note, sizeof c->note,
             "paired by round; noise floor of the A/A arms %.2g; %.100s against the paper's GeForce FX 5200",
             noise_floor, j->run->provenance.renderer);
    c->verdict = rl_verdict_equals(times.low * (1.0 - noise_floor), times.high * (1.0 + noise_floor),
                                   expected, 0.25 * expected);
    return RL_OK;
}

static int claim_rate(const struct rl_judging *j, const char *arm, const char *text, double paper)
{
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "rate";
    const struct rl_series *s = frames(j, arm);
    if (!s)
        return RL_OK;
    struct rl_interval ms = rl_interval_from_0(rl_median_interval(s->value, s->n, 0.95));
    double low = 1000.0 / ms.high, high = 1000.0 / ms.low;
    rl_claim_value(c, 1000.0 / ms.value, low, high, "frames/s");
    c->verdict = rl_verdict_at_least(low, high, RL_FILM_FPS);
    snprintf(c->note, sizeof c->note, "on %.100s; %.0f frames/s: %s; the paper %.0f on a GeForce FX 5200",
             j->run->provenance.renderer, RL_VIDEO_FPS, low >= RL_VIDEO_FPS ? "reached" : "not reached",
             paper);
    return RL_OK;
}

static int claim_noise_floor(const struct rl_judging *j, struct rl_interval same)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: the clock is fair: two arms of the same work differ by no more than 2 %");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "frames";
    rl_claim_value(c, same.value, same.low, same.high, "times");
    c->verdict = rl_verdict_equals(same.low, same.high, 1.0, 0.02);
    return RL_OK;
}

static int claim_environment(const struct rl_judging *j, double noise_floor)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: drawing the environment map anew costs less than the frame of random 4 that uses it");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "rate";
    struct rl_interval times = ratio(j, "environment", "random-4");
    rl_claim_value(c, times.value, times.low, times.high, "of a frame");
    snprintf(c->note, sizeof c->note, "paired by round; noise floor of the A/A arms %.2g", noise_floor);
    c->verdict = rl_verdict_at_most(times.low - noise_floor, times.high + noise_floor, 1.0);
    return RL_OK;
}

/* Rounds end at a cap of number or time too: then some median is known less well. */
static int claim_precise(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: the clock is precise: every median of Table 1 has a 95 % interval within 2 %");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "frames";
    double worst = NAN;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "series=table1"));) {
        const struct rl_metric *m = rl_record_metric(r, "time_precision");
        if (!m || (worst >= m->value))
            continue;
        worst = m->value;
        char arm[RL_NAME_MAX];
        rl_parameter(r->parameters, "arm", arm, sizeof arm);
        const struct rl_metric *frames = rl_record_metric(r, "frames");
        snprintf(c->note, sizeof c->note, "the least certain: %s, after %.0f frames%s", arm,
                 frames ? frames->value : NAN,
                 worst > 0.02 ? ", when a cap on seconds or frames ended the rounds" : "");
    }
    rl_claim_value(c, worst, worst, worst, "of the median");
    c->verdict = rl_verdict_at_most(worst, worst, 0.02);
    return RL_OK;
}

int rl_fps_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        const struct rl_judging j = {run, scene, claims, error};
        struct rl_interval same = ratio(&j, "random-4-again", "random-4");
        double noise_floor = fmax(same.high - 1.0, 1.0 - same.low);
        status = claim_random_faster(&j, noise_floor);
        if (status == RL_OK)
            status = claim_plain(&j, noise_floor);
        if (status == RL_OK)
            status = claim_rate(&j, "random-4",
                                "paper: highlights of shaped lights nearly in real time: random 4 reaches 24 "
                                "frames/s on this renderer",
                                RL_PAPER_RANDOM_FPS);
        if (status == RL_OK)
            status = claim_rate(&j, "regular-13",
                                "paper: highlights of shaped lights nearly in real time: regular 13 reaches "
                                "24 frames/s on this renderer",
                                RL_PAPER_REGULAR_FPS);
        if (status == RL_OK)
            status = claim_noise_floor(&j, same);
        if (status == RL_OK)
            status = claim_precise(&j);
        if (status == RL_OK)
            status = claim_environment(&j, noise_floor);
    }
    return status == RL_OK ? rl_fps_judge_costs(claims, run, error) : status;
}
