/* Cases that an axis has made the same (see axis_merge.h). */
#include "studies/axis_merge.h"

#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "studies/axis.h"

static uint64_t hash_case(const struct rl_record *r)
{
    uint64_t hash = rl_hash_bytes(RL_HASH_START, r->scene, strlen(r->scene) + 1);
    return rl_hash_bytes(hash, r->parameters, strlen(r->parameters));
}

static bool same_case(const struct rl_record *a, const struct rl_record *b)
{
    return strcmp(a->scene, b->scene) == 0 && strcmp(a->parameters, b->parameters) == 0;
}

/* Marks a group's cases that are the same as an earlier one of it, and gives the others its size: how many these are. */
static void weigh_group(const struct rl_run *run, size_t first, size_t end, size_t *weight)
{
    size_t n = 0;
    for (size_t i = first; i < end; i++) {
        bool again = false;
        for (size_t k = first; k < i && !again; k++)
            again = weight[k] > 0 && same_case(&run->record[k], &run->record[i]);
        weight[i] = !again;
        n += !again;
    }
    for (size_t i = first; i < end; i++)
        weight[i] *= n;
}

/* Of cases that are the same, the one in the largest group stays, which has the most beside it to be held against; else the first.
 * `weight` is 0 for those that go. */
static void weigh(const struct rl_run *run, size_t *weight, size_t *table, size_t size)
{
    for (size_t first = 0, end; first < run->n_records; first = end) {
        for (end = first + 1; end < run->n_records && run->record[end].group == run->record[first].group;)
            end++;
        weigh_group(run, first, end, weight);
    }
    for (size_t i = 0; i < run->n_records; i++) {
        if (weight[i] == 0)
            continue;
        size_t at = hash_case(&run->record[i]) & (size - 1);
        while (table[at] && !same_case(&run->record[table[at] - 1], &run->record[i]))
            at = (at + 1) & (size - 1);
        bool better = !table[at] || weight[i] > weight[table[at] - 1];
        if (table[at])
            weight[better ? table[at] - 1 : i] = 0;
        if (better)
            table[at] = i + 1;
    }
}

/* Planned records own nothing, so that one may be copied over another. */
int rl_axis_merge(struct rl_run *run, struct rl_error *error)
{
    /* An open hash table of records' numbers, plus one; at most half full. */
    size_t size = 16, kept = 0;
    while (size < 2 * run->n_records)
        size *= 2;
    size_t *table = calloc(size, sizeof *table), *weight = calloc(run->n_records + 1, sizeof *weight);
    if (table && weight)
        weigh(run, weight, table, size);
    for (size_t i = 0; table && weight && i < run->n_records; i++)
        if (weight[i] > 0) {
            if (kept != i)
                run->record[kept] = run->record[i];
            kept++;
        }
    int status = table && weight ? RL_OK : rl_fail_memory(error, "a list of cases");
    run->n_records = status == RL_OK ? kept : run->n_records;
    free(table);
    free(weight);
    return status;
}

const char *const rl_axis_extras[] = {"rounds", "columns", "keep", NULL};

/* Whether two cases are the same but that the second has more of that kind. */
static bool has_more(const struct rl_record *without, const struct rl_record *with, const char *key)
{
    char stripped[RL_PARAMETERS_MAX];
    return rl_parameter_number(with->parameters, key) > 0.0 && strcmp(without->scene, with->scene) == 0 &&
           rl_parameters_replace(stripped, with->parameters, key, "0", NULL) == RL_OK &&
           strcmp(stripped, without->parameters) == 0;
}

void rl_axis_drop_less(struct rl_run *run, const char *key)
{
    size_t kept = 0;
    for (size_t i = 0; i < run->n_records; i++) {
        bool less = false;
        if (rl_parameter_number(run->record[i].parameters, key) == 0.0)
            for (size_t k = 0; k < run->n_records && !less; k++)
                less = k != i && (k < kept || k > i) && has_more(&run->record[i], &run->record[k], key);
        if (less)
            continue;
        if (kept != i)
            run->record[kept] = run->record[i];
        kept++;
    }
    run->n_records = kept;
}
