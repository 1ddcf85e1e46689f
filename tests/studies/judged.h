/* What a study makes of a run that was made up: one claim by its words; and that nothing measured decides nothing. Include after
 * cmocka.h. */
#ifndef RL_TESTS_STUDIES_JUDGED_H
#define RL_TESTS_STUDIES_JUDGED_H

#include <math.h>
#include <string.h>

#include "studies/study.h"

/* The claim that has these words. */
static inline struct rl_claim claim_of(const char *study, const struct rl_run *run, const char *words)
{
    struct rl_claims claims = {0};
    struct rl_claim found = {.verdict = (enum rl_verdict) - 1};
    assert_int_equal(rl_study_find(study)->judge(&claims, run, NULL), RL_OK);
    for (size_t i = 0; i < claims.n; i++)
        if (strstr(claims.claim[i].text, words))
            found = claims.claim[i];
    rl_claims_clear(&claims);
    if ((int)found.verdict < 0)
        fail_msg("no claim says '%s'", words);
    return found;
}

/* With every case planned or failed, `least` claims or more are all inconclusive, without a number. */
static inline void check_undecided(const char *study, struct rl_run *run, size_t least)
{
    struct rl_claims claims = {0};
    for (size_t i = 0; i < run->n_records; i++)
        run->record[i].status = i % 2 ? RL_RECORD_PLANNED : RL_RECORD_FAILED;
    assert_int_equal(rl_study_find(study)->judge(&claims, run, NULL), RL_OK);
    assert_true(claims.n >= least);
    for (size_t i = 0; i < claims.n; i++) {
        assert_int_equal(claims.claim[i].verdict, RL_VERDICT_INCONCLUSIVE);
        assert_true(isnan(claims.claim[i].value));
    }
    rl_claims_clear(&claims);
}

#endif
