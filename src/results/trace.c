/* Notes which records a judge reads (see trace.h). Each record of a traced run points at its own mark. */
#include "results/trace.h"

#include <stdlib.h>
#include <string.h>

enum {
    READ = RL_RECORD_READ, /* since the last claim was begun */
    COMMON = 2             /* before its scene's first claim: it counts for all of them */
};

struct rl_trace {
    struct rl_run *run;
    size_t first; /* of the run's claims */
    unsigned char mark[];
};

int rl_trace_begin(struct rl_claims *claims, struct rl_run *run, struct rl_error *error)
{
    struct rl_trace *t = calloc(1, sizeof *t + run->n_records);
    if (!t)
        return rl_fail_memory(error, "the cases that claims come from");
    t->run = run;
    t->first = claims->n;
    for (size_t i = 0; i < run->n_records; i++)
        run->record[i].mark = &t->mark[i];
    claims->trace = t;
    return RL_OK;
}

static int add_case(struct rl_claim *c, const char *identity, struct rl_error *error)
{
    char(*grown)[RL_HASH_TEXT] = realloc(c->identity, (c->n_cases + 1) * sizeof *grown);
    if (!grown)
        return rl_fail_memory(error, "the cases of a claim");
    c->identity = grown;
    memcpy(grown[c->n_cases++], identity, RL_HASH_TEXT);
    return RL_OK;
}

int rl_trace_take(struct rl_claims *claims, struct rl_error *error)
{
    struct rl_trace *t = claims->trace;
    if (!t)
        return RL_OK;
    struct rl_claim *c = claims->n > t->first ? &claims->claim[claims->n - 1] : NULL;
    int status = RL_OK;
    for (size_t i = 0; i < t->run->n_records && status == RL_OK; i++) {
        const struct rl_record *r = &t->run->record[i];
        bool own = c && strcmp(r->scene, c->scene) == 0;
        if (own && t->mark[i])
            status = add_case(c, r->identity, error);
        if (!own && (t->mark[i] & READ))
            t->mark[i] = COMMON;
        t->mark[i] &= COMMON;
    }
    return status;
}

int rl_trace_end(struct rl_claims *claims, struct rl_error *error)
{
    struct rl_trace *t = claims->trace;
    if (!t)
        return RL_OK;
    int status = rl_trace_take(claims, error);
    for (size_t i = 0; i < t->run->n_records; i++)
        t->run->record[i].mark = NULL;
    free(t);
    claims->trace = NULL;
    return status;
}
