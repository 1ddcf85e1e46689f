/* Notes which records a judge reads (see trace.h). Each record of a traced run points at its own mark. */
#include "results/trace.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
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

/* Adds one more to a list with ", " between two, once; of a list that is full the end is "...". */
static void add_once(char list[], size_t size, const char *value)
{
    size_t used = strlen(list), length = strlen(value);
    for (const char *at = list; (at = strstr(at, value)); at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ',' || at[length] == '\0'))
            return;
    if (used >= 3 && strcmp(list + used - 3, "...") == 0)
        return;
    bool fits = used + length + 8 < size;
    snprintf(list + used, size - used, "%s%s", used ? ", " : "", fits ? value : "...");
}

/* What a number stands for beside its parameters: frames may be timed at a size of their own. */
static void add_extent(struct rl_claim *c, const char *parameters)
{
    static const char *const side[][2] = {{"width", "height"}, {"timed_width", "timed_height"}};
    for (size_t i = 0; i < sizeof side / sizeof side[0]; i++) {
        double width = rl_parameter_number(parameters, side[i][0]);
        double height = rl_parameter_number(parameters, side[i][1]);
        char size[48];
        snprintf(size, sizeof size, "%s%gx%g", i ? "timed " : "", width, height);
        if (!isnan(width) && !isnan(height))
            add_once(c->size_px, sizeof c->size_px, size);
    }
    char seeds[24];
    double n = rl_parameter_number(parameters, "seeds");
    snprintf(seeds, sizeof seeds, "%g", n);
    if (!isnan(n))
        add_once(c->seeds, sizeof c->seeds, seeds);
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
        if (own && t->mark[i])
            add_extent(c, r->parameters);
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
