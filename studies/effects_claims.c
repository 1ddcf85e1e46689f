/* The claims that the study `effects` judges. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "studies/effects.h"
#include "studies/judging.h"

static const char all[] = "feature=all kind=base";

/* A word of a note: "phong: 0.03". */
static void note(struct rl_claim *c, const char *name, double value)
{
    size_t used = strlen(c->note);
    snprintf(c->note + used, sizeof c->note - used, "%s%.40s: %.3g", used ? "; " : "", name, value);
}

/* Whether the record is of a feature of that kind (NULL: any) that the scene names. */
static bool is_named(const struct rl_record *r, const char *kind)
{
    char name[RL_NAME_MAX];
    const struct rl_metric *named = rl_record_metric(r, "named");
    rl_parameter(r->parameters, "kind", name, sizeof name);
    return named && named->value > 0.0 && (!kind || strcmp(name, kind) == 0);
}

static const char *feature_of(char name[RL_NAME_MAX], const struct rl_record *r)
{
    rl_parameter(r->parameters, "feature", name, RL_NAME_MAX);
    return name;
}

/* Gives the claim a ratio of times, its interval made wider by so many times the floor (what two arms of the same work differ by, see
 * claim_both_ways) over the full frame. Without the floor nothing tells chance from a price. */
static void ratio_with_floor(struct rl_claim *c, const struct rl_judging *j, const char *metric, double times)
{
    const struct rl_metric *ratio = rl_judging_metric(j, all, metric);
    const struct rl_metric *full = rl_judging_metric(j, all, "full_ms");
    const struct rl_metric *floor_ms = rl_judging_metric(j, all, "floor_ms");
    if (!ratio || !full || !floor_ms)
        return;
    double room = times * floor_ms->value / full->value;
    rl_claim_value(c, ratio->value, ratio->low - room, ratio->high + room, "times");
    snprintf(c->note, sizeof c->note, "two arms of the same work differ by up to %.2g ms of %.3g",
             floor_ms->value, full->value);
}

static int claim_zero_time(const struct rl_judging *j)
{
    struct rl_claim *c =
        rl_judging_claim(j, "ours: an effect with coefficients of 0 costs what one costs that the scene does "
                            "not name, no time: with every "
                            "other effect named so the full frame takes as long (1 to within 2 %)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    ratio_with_floor(c, j, "time_zero", 1.0);
    c->verdict = rl_verdict_equals(c->low, c->high, 1.0, 0.02);
    return RL_OK;
}

static int claim_zero_work(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: and no work: not a draw, a triangle, a program, a module, a texture or a byte more");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    const struct rl_metric *work = rl_judging_metric(j, all, "zero_work");
    if (work)
        rl_claim_value(c, work->value, work->low, work->high, "more, in all");
    c->verdict = rl_verdict_equals(c->low, c->high, 0.0, 0.0);
    return RL_OK;
}

/* The effect whose two prices are farthest apart speaks for all; both intervals and the floor count. */
static int claim_both_ways(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: what an effect adds to a bare scene is what its removal "
                                             "saves of the full one (milliseconds, difference "
                                             "over the full frame: 0 to within 5 %, worst effect)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    const struct rl_metric *full = rl_judging_metric(j, all, "full_ms");
    const struct rl_metric *floor_ms = rl_judging_metric(j, all, "floor_ms");
    char name[RL_NAME_MAX], worst[RL_NAME_MAX] = "";
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "kind=effect"));) {
        const struct rl_metric *added = rl_record_metric(r, "added_ms");
        const struct rl_metric *removed = rl_record_metric(r, "removed_ms");
        if (!is_named(r, "effect") || !added || !removed || !full || !floor_ms)
            continue;
        double off = (added->value - removed->value) / full->value;
        if (fabs(off) <= fabs(c->value))
            continue;
        rl_claim_value(c, off, (added->low - removed->high - floor_ms->value) / full->value,
                       (added->high - removed->low + floor_ms->value) / full->value, "of the full frame");
        snprintf(worst, sizeof worst, "%s", feature_of(name, r));
    }
    if (worst[0])
        snprintf(c->note, sizeof c->note, "of %.40s", worst);
    c->verdict = rl_verdict_equals(c->low, c->high, 0.0, 0.05);
    return RL_OK;
}

/* The differences of arms in `time_sum`: with a feature and without, for each that it adds up (culling is not one), and the bare frame
 * against the full one. */
static double differences_of_sum(const struct rl_judging *j)
{
    double n = 1.0;
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, ""));)
        n += is_named(r, NULL) && !rl_parameters_match(r->parameters, "feature=culling kind=switch");
    return n;
}

/* Each of the sum's differences may be off by the floor. Were arms each on their own, n of them would be off by its sqrt(n) times; but one
 * arm, the bare frame, is in all of them, and what it is off by is there n times over: the floor of the sum is n times that of one. */
static int claim_sum(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(
        j, "ours: prices add up: the bare frame and all that is added to it, one by one, make the full "
           "frame (1 to within a tenth)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    ratio_with_floor(c, j, "time_sum", differences_of_sum(j));
    c->verdict = rl_verdict_equals(c->low, c->high, 1.0, 0.1);
    return RL_OK;
}

/* Nothing goes with an effect that it had not brought. */
static int claim_share(const struct rl_judging *j)
{
    static const char *const work[] = {"draws", "triangles", "bytes", "textures", "programs", "modules"};
    struct rl_claim *c = rl_judging_claim(j, "ours: no draw, triangle, byte, texture, program or module goes "
                                             "with an effect that it would not bring to a "
                                             "bare scene (cases of more going than came)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    double more = 0.0;
    size_t seen = 0;
    char name[RL_NAME_MAX];
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "kind=effect"));)
        for (size_t k = 0; k < sizeof work / sizeof work[0] && is_named(r, "effect"); k++) {
            char came[RL_NAME_MAX], gone[RL_NAME_MAX];
            snprintf(came, sizeof came, "added_%s", work[k]);
            snprintf(gone, sizeof gone, "removed_%s", work[k]);
            const struct rl_metric *a = rl_record_metric(r, came), *b = rl_record_metric(r, gone);
            if (!a || !b)
                continue;
            seen++;
            more += b->value > a->value;
            if (b->value > a->value)
                note(c, feature_of(name, r), b->value - a->value);
        }
    if (seen > 0)
        rl_claim_value(c, more, more, more, "cases");
    c->verdict = rl_verdict_at_most(c->low, c->high, 0.0);
    return RL_OK;
}

/* The dearest effect against the highlight that samples. Both ends of both intervals count, and the floor of both. */
static int claim_dearest(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: no effect costs more than the highlight of random "
                                             "normals (milliseconds added to a bare scene, dearest "
                                             "effect over it)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    const struct rl_metric *random = rl_judging_metric(j, "feature=random kind=highlight", "added_ms");
    const struct rl_metric *dearest = NULL;
    char name[RL_NAME_MAX];
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, "kind=effect"));) {
        const struct rl_metric *added = rl_record_metric(r, "added_ms");
        if (!is_named(r, "effect") || !added || (dearest && added->value <= dearest->value))
            continue;
        dearest = added;
        feature_of(name, r);
    }
    const struct rl_metric *floor_ms = rl_judging_metric(j, all, "floor_ms");
    if (dearest && random && floor_ms) {
        struct rl_metric above = *dearest, below = *random;
        above.low -= floor_ms->value;
        above.high += floor_ms->value;
        below.low -= floor_ms->value;
        below.high += floor_ms->value;
        rl_judging_ratio(c, &above, &below, "times");
        snprintf(c->note, sizeof c->note, "of %.40s", name);
    }
    c->verdict = rl_verdict_at_most(c->low, c->high, 1.0);
    return RL_OK;
}

/* That which shows least speaks for all. */
static int claim_shows(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "ours: every effect and highlight shows: without it some pixel "
                                             "of the full scene is off by more than 1/255 "
                                             "(worst pixel of the one that shows least)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    char name[RL_NAME_MAX];
    for (const struct rl_record *r = NULL; (r = rl_run_next(j->run, r, j->scene, ""));) {
        const struct rl_metric *max = rl_record_metric(r, "max");
        if (!max || !(is_named(r, "effect") || is_named(r, "highlight")) || max->value >= c->value)
            continue;
        rl_claim_value(c, max->value, max->low, max->high, "of full scale");
        snprintf(c->note, sizeof c->note, "of %.40s", feature_of(name, r));
    }
    c->verdict = rl_verdict_at_least(c->low, c->high, RL_STEP_OF_8_BITS);
    return RL_OK;
}

static int claim_spheres(const struct rl_judging *j)
{
    struct rl_claim *c = rl_judging_claim(j, "paper: the bounding spheres save time: the full frame takes "
                                             "longer without them (milliseconds saved)");
    if (!c)
        return RL_ERR_SYSTEM;
    c->figure = "price";
    const struct rl_metric *removed = rl_judging_metric(j, "feature=sphere", "removed_ms");
    const struct rl_metric *floor_ms = rl_judging_metric(j, all, "floor_ms");
    if (!removed || !floor_ms)
        return RL_OK;
    rl_claim_value(c, -removed->value, -removed->high, -removed->low, "ms");
    c->verdict = rl_verdict_at_least(c->low - floor_ms->value, c->high + floor_ms->value, 0.0);
    return RL_OK;
}

int rl_effects_judge(struct rl_claims *claims, const struct rl_run *run, struct rl_error *error)
{
    int (*const claim[])(const struct rl_judging *) = {claim_zero_time, claim_zero_work, claim_both_ways,
                                                       claim_sum,       claim_share,     claim_dearest,
                                                       claim_shows,     claim_spheres};
    int status = RL_OK;
    const char *scene;
    for (size_t i = 0; status == RL_OK && (scene = rl_run_scene(run, i)); i++) {
        const struct rl_judging j = {run, scene, claims, error};
        for (size_t k = 0; k < sizeof claim / sizeof claim[0] && status == RL_OK; k++)
            status = claim[k](&j);
    }
    return status;
}
