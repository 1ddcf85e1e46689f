/* What a study makes of a run that was made up: one claim by its words; and that nothing measured decides nothing. Include after
 * cmocka.h. */
#ifndef RL_TESTS_STUDIES_JUDGED_H
#define RL_TESTS_STUDIES_JUDGED_H

#include <math.h>
#include <string.h>

#include "results/trace.h"
#include "studies/study.h"

/* A number comes from cases, and a figure shows it. */
static inline void check_source(const struct rl_study *study, const struct rl_claim *c)
{
    if (!isnan(c->value) && c->n_cases == 0)
        fail_msg("'%s' has a number, but no figure was read for it after it was begun", c->text);
    bool alone = strcmp(c->scene, RL_NO_SCENE) == 0, shown = false;
    const struct rl_figure *figure = alone ? study->figures_alone : study->figures;
    for (size_t i = 0; i < (alone ? study->n_figures_alone : study->n_figures); i++)
        shown = shown || (c->figure && strcmp(figure[i].name, c->figure) == 0);
    if (!shown)
        fail_msg("'%s' names the figure '%s', which %s does not have", c->text, c->figure ? c->figure : "",
                 study->name);
}

/* What a study makes of a run. */
static inline void judge_run(struct rl_claims *claims, const char *name, const struct rl_run *run)
{
    const struct rl_study *study = rl_study_find(name);
    assert_non_null(study);
    /* The run is the test's own, and as it was when the trace ends. */
    assert_int_equal(rl_trace_begin(claims, (struct rl_run *)run, NULL), RL_OK);
    assert_int_equal(study->judge(claims, run, NULL), RL_OK);
    assert_int_equal(rl_trace_end(claims, NULL), RL_OK);
    for (size_t i = 0; i < claims->n; i++)
        check_source(study, &claims->claim[i]);
}

/* The claim that has these words. */
static inline struct rl_claim claim_of(const char *study, const struct rl_run *run, const char *words)
{
    struct rl_claims claims = {0};
    struct rl_claim found = {.verdict = (enum rl_verdict) - 1};
    judge_run(&claims, study, run);
    for (size_t i = 0; i < claims.n; i++)
        if (strstr(claims.claim[i].text, words))
            found = claims.claim[i];
    rl_claims_clear(&claims);
    if ((int)found.verdict < 0)
        fail_msg("no claim says '%s'", words);
    return found;
}

/* `at`: what the world that it was judged in was given. */
static inline void check_verdict(const struct rl_claim *c, enum rl_verdict expected, const char *words,
                                 double at)
{
    if (c->verdict != expected)
        fail_msg("'%s' at %g: %s, expected %s", words, at, rl_verdict_name(c->verdict),
                 rl_verdict_name(expected));
}

/* With every case planned or failed, `least` claims or more are all inconclusive, without a number. */
static inline void check_undecided(const char *study, struct rl_run *run, size_t least)
{
    struct rl_claims claims = {0};
    for (size_t i = 0; i < run->n_records; i++)
        run->record[i].status = i % 2 ? RL_RECORD_PLANNED : RL_RECORD_FAILED;
    judge_run(&claims, study, run);
    assert_true(claims.n >= least);
    for (size_t i = 0; i < claims.n; i++) {
        assert_int_equal(claims.claim[i].verdict, RL_VERDICT_INCONCLUSIVE);
        assert_true(isnan(claims.claim[i].value));
    }
    rl_claims_clear(&claims);
}

/* Every case that was planned is another one; and once all are measured, each pattern finds one. */
static inline void check_plan(struct rl_run *run, const char *const *needed, size_t n)
{
    rl_run_identify(run, "env");
    for (size_t i = 0; i < run->n_records; i++) {
        run->record[i].status = RL_RECORD_OK;
        for (size_t k = 0; k < i; k++)
            assert_string_not_equal(run->record[i].identity, run->record[k].identity);
    }
    for (size_t i = 0; i < n; i++)
        if (!rl_run_find(run, NULL, needed[i]))
            fail_msg("no case of %s is '%s'", run->study, needed[i]);
}

#endif
