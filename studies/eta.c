/* Guesses the time left, better and better (see eta.h). */
#include "studies/eta.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "studies/forecast.h"

int rl_eta_add(struct rl_eta *eta, const struct rl_run *run, size_t first, const struct rl_run *times,
               struct rl_error *error)
{
    struct rl_eta_group *grown = realloc(eta->group, (eta->total + 1) * sizeof *grown);
    if (!grown)
        return rl_fail_memory(error, "the groups to be measured");
    eta->group = grown;
    struct rl_eta_group *g = &grown[eta->total++];
    *g = (struct rl_eta_group){.first = &run->record[first], .open = true};
    g->distance = rl_forecast_guess(&g->seconds, g->first, times);
    if (g->distance < 0)
        g->seconds = rl_forecast_first(run, first);
    return RL_OK;
}

static struct rl_eta_group *find(const struct rl_eta *eta, const struct rl_record *first)
{
    for (size_t i = 0; i < eta->total; i++)
        if (eta->group[i].first == first)
            return &eta->group[i];
    return NULL;
}

static bool same_study(const struct rl_eta_group *a, const struct rl_eta_group *b)
{
    return strcmp(a->first->study, b->first->study) == 0;
}

void rl_eta_measured(struct rl_eta *eta, const struct rl_record *first)
{
    struct rl_eta_group *g = find(eta, first);
    if (!g || !g->open)
        return;
    g->open = false;
    g->seconds = first->seconds;
    eta->done++;
    for (size_t i = 0; i < eta->total; i++) {
        struct rl_eta_group *other = &eta->group[i];
        if (!other->open || !same_study(g, other))
            continue;
        /* What was measured just now, here, is worth more than what is as much alike and from before. */
        double seconds;
        int distance = rl_forecast_scale(&seconds, other->first, first);
        if (distance < 0 || (other->distance >= 0 && distance > other->distance))
            continue;
        other->distance = distance;
        other->seconds = seconds;
    }
}

void rl_eta_dropped(struct rl_eta *eta, const struct rl_record *first)
{
    struct rl_eta_group *g = find(eta, first);
    if (!g || !g->open)
        return;
    *g = eta->group[--eta->total];
}

/* The mean of the groups of which something is known: of one's study (NULL: of all). NaN if there is none. */
static double mean(const struct rl_eta *eta, const struct rl_eta_group *like)
{
    double sum = 0.0, n = 0.0;
    for (size_t i = 0; i < eta->total; i++) {
        const struct rl_eta_group *g = &eta->group[i];
        if (isnan(g->seconds) || (like && !same_study(g, like)))
            continue;
        sum += g->seconds;
        n++;
    }
    return n > 0.0 ? sum / n : NAN;
}

double rl_eta_seconds(const struct rl_eta *eta)
{
    double sum = 0.0, of_all = NAN, of_study = NAN;
    const struct rl_eta_group *unknown =
        NULL; /* whose study's mean of_study is: groups come study by study */
    for (size_t i = 0; i < eta->total; i++) {
        const struct rl_eta_group *g = &eta->group[i];
        if (!g->open)
            continue;
        if (!isnan(g->seconds)) {
            sum += g->seconds;
            continue;
        }
        if (!unknown || !same_study(unknown, g)) {
            of_study = mean(eta, g);
            of_all = unknown ? of_all : mean(eta, NULL);
            unknown = g;
        }
        sum += isnan(of_study) ? of_all : of_study;
    }
    return sum;
}

void rl_eta_clear(struct rl_eta *eta)
{
    free(eta->group);
    *eta = (struct rl_eta){0};
}
