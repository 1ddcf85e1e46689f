/* Adds up what there is to do (see cost.h). */
#include "studies/cost.h"

#include <math.h>

/* What a case has of that name, or `otherwise`: nothing of it, or a word. */
static double number(const struct rl_record *r, const char *key, double otherwise)
{
    double x = rl_parameter_number(r->parameters, key);
    return isnan(x) ? otherwise : x;
}

static double at_least_one(double x)
{
    return x > 1.0 ? x : 1.0;
}

/* Of one picture. */
static double pixels(const struct rl_record *r)
{
    double size = number(r, "size", 0.0), film = number(r, "width", 0.0) * number(r, "height", 0.0);
    if (film > 0.0)
        return film;
    return size > 0.0 ? size * size : at_least_one(number(r, "points", 1.0));
}

static double case_seconds(const struct rl_cost *c, const struct rl_record *r)
{
    static const double million = 1e6;
    double pictures = at_least_one(number(r, "seeds", 1.0)) * at_least_one(number(r, "views", 1.0));
    double frames = number(r, "rounds", 0.0) + number(r, "frames", 0.0);
    double timed = number(r, "timed_width", 0.0) * number(r, "timed_height", 0.0);
    double map = number(r, "normal_size", 0.0);
    double drawn = (pictures * pixels(r) + frames * (timed > 0.0 ? timed : pixels(r))) / million;
    return c->picture * (pictures + frames) + c->pixel * drawn +
           c->sample * drawn * at_least_one(number(r, "samples", 1.0)) +
           c->texel * map * map * pictures / million + c->second * number(r, "seconds", 0.0);
}

double rl_cost_seconds(const struct rl_cost *costs, size_t n_costs, const struct rl_record *group, size_t n)
{
    for (size_t i = 0; i < n_costs; i++) {
        if (!rl_parameters_match(group->parameters, costs[i].pattern))
            continue;
        double sum = costs[i].group;
        for (size_t k = 0; k < n; k++)
            sum += case_seconds(&costs[i], &group[k]);
        return sum;
    }
    return NAN;
}
