/* The claims that the study `accuracy` judges about one scene's images, from seconds by round. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/accuracy.h"

/* The bars were set for the shipped scenes. */
static const struct {
    const char *scene;
    double seconds;
} bars[] = {{"sphere-quad", 2.0}, {"teapot-star", 5.0}};

double rl_accuracy_bar(const char *scene)
{
    for (size_t i = 0; i < sizeof bars / sizeof bars[0]; i++)
        if (strcmp(bars[i].scene, scene) == 0)
            return bars[i].seconds;
    return NAN;
}

static const struct rl_series *seconds_of(const struct rl_judging *j, const char *pattern)
{
    const struct rl_record *r = rl_run_find(j->run, j->scene, pattern);
    return r ? rl_record_series(r, "seconds") : NULL;
}

/* Other programs slow two threads down more than one. What is said about threads is said of rounds in which they took no more than
 * this of a core. */
static const double others_most = 0.1;

enum { ROUNDS_MAX = 64 };

/* The quiet rounds' times of two records, in pairs (a and b may be one). Returns how many. */
static size_t quiet_rounds(double x[ROUNDS_MAX], double y[ROUNDS_MAX], const struct rl_record *a,
                           const struct rl_record *b)
{
    const struct rl_series *time_a = rl_record_series(a, "seconds"), *time_b = rl_record_series(b, "seconds"),
                           *others_a = rl_record_series(a, "others"),
                           *others_b = rl_record_series(b, "others");
    size_t n = 0;
    for (size_t i = 0; i < time_a->n && i < time_b->n && n < ROUNDS_MAX; i++)
        if (others_a->value[i] <= others_most && others_b->value[i] <= others_most) {
            x[n] = time_a->value[i];
            y[n++] = time_b->value[i];
        }
    return n;
}

/* An upper bound is all that it takes: of five rounds the longest is one of 1 - 2^-5, 96.9 %, where an interval of 95 % takes six. */
static struct rl_interval at_most(const struct rl_series *s)
{
    struct rl_interval x = rl_interval_from_0(rl_median_interval(s->value, s->n, 0.95));
    for (size_t i = 0; i < s->n && s->n == 5; i++)
        x.high = i > 0 ? fmax(x.high, s->value[i]) : s->value[i];
    return x;
}

static int claim_seconds(const struct rl_judging *j, double bar)
{
    char text[160];
    snprintf(text, sizeof text, "ours: an image of 640x480 to 1e-6 takes at most %g s on two cores", bar);
    struct rl_claim *c = rl_judging_claim(j, text);
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "seconds";
    const struct rl_series *s =
        seconds_of(j, "part=images method=reference tolerance=1e-06 threads=2 width=640 height=480");
    if (!s)
        return RL_OK;
    struct rl_interval x = at_most(s);
    rl_claim_value(c, x.value, x.low, x.high, "s");
    c->verdict = rl_verdict_at_most(x.low, x.high, bar);
    snprintf(c->note, sizeof c->note, "%zu rounds, by the clock on the wall, on %.100s", s->n,
             j->run->provenance.cpu);
    return RL_OK;
}

static int claim_speed_up(const struct rl_judging *j)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: two threads draw the image to 1e-6 at least 1.8 times as fast as one");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "seconds";
    const struct rl_record *one =
        rl_run_find(j->run, j->scene, "part=images method=reference tolerance=1e-06 threads=1");
    if (!one)
        return RL_OK;
    char pattern[128]; /* an image of 640x480 may have been timed on two threads alone */
    snprintf(pattern, sizeof pattern, "part=images method=reference tolerance=1e-06 threads=2 width=%g",
             rl_parameter_number(one->parameters, "width"));
    const struct rl_record *two = rl_run_find(j->run, j->scene, pattern);
    if (!two)
        return RL_OK;
    double x[ROUNDS_MAX], y[ROUNDS_MAX];
    size_t n = quiet_rounds(x, y, one, two);
    snprintf(c->note, sizeof c->note,
             "paired by round; %zu of %zu rounds in which other programs took at most %g of a core", n,
             rl_record_series(one, "seconds")->n, others_most);
    struct rl_interval times = rl_interval_from_0(rl_ratio_interval(x, y, n, 0.95));
    if (n == 0) { /* the disturbed ones have a number, and it bounds nothing */
        const struct rl_series *a = rl_record_series(one, "seconds"), *b = rl_record_series(two, "seconds");
        times = rl_ratio_interval(a->value, b->value, a->n < b->n ? a->n : b->n, 0.95);
        times.low = 0.0;
        times.high = INFINITY;
    }
    rl_claim_value(c, times.value, times.low, times.high, "times");
    c->verdict = rl_verdict_at_least(times.low, times.high, 1.8);
    return RL_OK;
}

static int claim_growth(const struct rl_judging *j)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: an image to 1e-8 takes at most twice as long as one to 1e-3");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "seconds";
    const struct rl_series *coarse = seconds_of(j, "part=images method=reference tolerance=0.001"),
                           *fine = seconds_of(j, "part=images method=reference tolerance=1e-08");
    if (!coarse || !fine)
        return RL_OK;
    size_t n = fine->n < coarse->n ? fine->n : coarse->n;
    struct rl_interval x = rl_interval_from_0(rl_ratio_interval(fine->value, coarse->value, n, 0.95));
    rl_claim_value(c, x.value, x.low, x.high, "times");
    c->verdict = rl_verdict_at_most(x.low, x.high, 2.0);
    snprintf(c->note, sizeof c->note, "%zu rounds, paired; Monte Carlo: 1e10 times", n);
    return RL_OK;
}

static int claim_exhaustive(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: exhaustive draws an image at 1e9 texel-normals per "
                                             "second or more on two threads, all included");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "seconds";
    const struct rl_record *r = rl_run_find(j->run, j->scene, "part=images method=exhaustive threads=2");
    if (!r)
        return RL_OK;
    double seconds[ROUNDS_MAX], same[ROUNDS_MAX];
    double texels = rl_record_metric(r, "texel_normals")->value * rl_record_metric(r, "seconds")->value;
    size_t n = quiet_rounds(seconds, same, r, r);
    snprintf(c->note, sizeof c->note,
             "rays, maps and poles included; %zu of %zu rounds in which others took at most %g of a core; on "
             "%.100s",
             n, rl_record_series(r, "seconds")->n, others_most, j->run->provenance.cpu);
    struct rl_interval x = rl_interval_from_0(rl_median_interval(seconds, n, 0.95));
    if (n < 6) { /* others only slow it down: the rate beside them is a lower bound */
        const struct rl_series *all = rl_record_series(r, "seconds");
        x = rl_interval_from_0(rl_median_interval(all->value, all->n, 0.95));
        x.low = 0.0;
    }
    rl_claim_value(c, texels / x.value, texels / x.high, texels / x.low, "texel-normals/s");
    c->verdict = rl_verdict_at_least(c->low, c->high, 1e9);
    return RL_OK;
}

int rl_accuracy_judge_images(const struct rl_judging *j)
{
    double bar = rl_accuracy_bar(j->scene);
    int status = isnan(bar) ? RL_OK : claim_seconds(j, bar);
    if (status == RL_OK)
        status = claim_speed_up(j);
    if (status == RL_OK)
        status = claim_growth(j);
    return status == RL_OK ? claim_exhaustive(j) : status;
}
