/* See spent.h. */
#include "studies/spent.h"

#include <stdio.h>

#include "base/clock.h"

const char *rl_spent_name(enum rl_spent_kind kind)
{
    static const char *const name[] = {[RL_SPENT_MEASURED] = "measured",
                                       [RL_SPENT_REFERENCE] = "reference",
                                       [RL_SPENT_SETUP] = "setup",
                                       [RL_SPENT_EVALUATION] = "evaluation",
                                       [RL_SPENT_HARNESS] = "harness"};
    return name[kind];
}

void rl_spent_begin(struct rl_spent *spent, enum rl_spent_kind kind)
{
    *spent = (struct rl_spent){.since = rl_clock_seconds(), .now = kind};
}

enum rl_spent_kind rl_spent_on(struct rl_spent *spent, enum rl_spent_kind kind)
{
    enum rl_spent_kind before = spent->now;
    double now = rl_clock_seconds();
    spent->seconds[before] += now - spent->since;
    spent->since = now;
    spent->now = kind;
    return before;
}

void rl_spent_text(char text[], size_t size, const double seconds[RL_SPENT_KINDS])
{
    double all = 0.0;
    for (int k = 0; k < RL_SPENT_KINDS; k++)
        all += seconds[k];
    size_t used = (size_t)snprintf(text, size, "%.1f s", all);
    int kinds = seconds[RL_SPENT_HARNESS] > 0.0 ? RL_SPENT_KINDS : RL_SPENT_HARNESS;
    for (int k = 0; k < kinds && used < size; k++)
        used += (size_t)snprintf(text + used, size - used, "%s %.1f %% %s", k ? "," : ":",
                                 all > 0.0 ? 100.0 * seconds[k] / all : 0.0,
                                 k == RL_SPENT_SETUP ? "set-up" : rl_spent_name((enum rl_spent_kind)k));
}
