/* Claims, verdicts and their table (see claims.h). */
#include "results/claims.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "results/trace.h"

struct rl_claim *rl_claims_add(struct rl_claims *claims, struct rl_error *error)
{
    if (rl_trace_take(claims, error) != RL_OK)
        return NULL;
    struct rl_claim *grown = realloc(claims->claim, (claims->n + 1) * sizeof *grown);
    if (!grown) {
        rl_error_set(error, RL_ERR_SYSTEM, "out of memory for a list of claims");
        return NULL;
    }
    claims->claim = grown;
    struct rl_claim *c = &grown[claims->n++];
    *c = (struct rl_claim){.verdict = RL_VERDICT_INCONCLUSIVE, .value = NAN, .low = NAN, .high = NAN};
    return c;
}

void rl_claims_clear(struct rl_claims *claims)
{
    rl_trace_end(claims, NULL);
    for (size_t i = 0; i < claims->n; i++)
        free(claims->claim[i].identity);
    free(claims->claim);
    *claims = (struct rl_claims){0};
}

void rl_claim_value(struct rl_claim *claim, double value, double low, double high, const char *unit)
{
    claim->value = value;
    claim->low = low;
    claim->high = high;
    snprintf(claim->unit, sizeof claim->unit, "%s", unit);
}

enum rl_verdict rl_verdict_at_least(double low, double high, double bound)
{
    if (low >= bound)
        return RL_VERDICT_HOLDS;
    return high < bound ? RL_VERDICT_FAILS : RL_VERDICT_INCONCLUSIVE;
}

enum rl_verdict rl_verdict_at_most(double low, double high, double bound)
{
    if (high <= bound)
        return RL_VERDICT_HOLDS;
    return low > bound ? RL_VERDICT_FAILS : RL_VERDICT_INCONCLUSIVE;
}

enum rl_verdict rl_verdict_equals(double low, double high, double target, double margin)
{
    if (high < target - margin || low > target + margin)
        return RL_VERDICT_FAILS;
    return low >= target - margin && high <= target + margin ? RL_VERDICT_HOLDS : RL_VERDICT_INCONCLUSIVE;
}

const char *rl_verdict_name(enum rl_verdict verdict)
{
    switch (verdict) {
    case RL_VERDICT_HOLDS:
        return "holds";
    case RL_VERDICT_HOLDS_UP_TO:
        return "holds up to";
    case RL_VERDICT_FAILS:
        return "fails";
    default:
        return "inconclusive";
    }
}

/* The identities, with a blank between two. */
static void export_cases(struct rl_export *table, const struct rl_claim *c)
{
    struct rl_buffer cases = {0};
    for (size_t k = 0; k < c->n_cases; k++)
        rl_buffer_printf(&cases, "%s%s", k ? " " : "", c->identity[k]);
    rl_export_text(table, cases.data ? cases.data : "");
    rl_buffer_clear(&cases);
}

void rl_claims_export(struct rl_buffer *out, const struct rl_claims *claims, enum rl_export_format format)
{
    static const char *const column[] = {"claim",   "verdict", "value",  "low",  "high",  "unit",    "study",
                                         "command", "scene",   "figure", "note", "cases", "size_px", "seeds"};
    struct rl_export table;
    rl_export_begin(&table, out, format, column, sizeof column / sizeof column[0]);
    for (size_t i = 0; i < claims->n; i++) {
        const struct rl_claim *c = &claims->claim[i];
        rl_export_text(&table, c->text);
        rl_export_text(&table, rl_verdict_name(c->verdict));
        rl_export_number(&table, c->value);
        rl_export_number(&table, c->low);
        rl_export_number(&table, c->high);
        rl_export_text(&table, c->unit);
        rl_export_text(&table, c->study);
        rl_export_text(&table, c->command);
        rl_export_text(&table, c->scene);
        rl_export_text(&table, c->figure ? c->figure : "");
        rl_export_text(&table, c->note);
        export_cases(&table, c);
        rl_export_text(&table, c->size_px);
        rl_export_text(&table, c->seeds);
    }
    rl_export_end(&table);
}
