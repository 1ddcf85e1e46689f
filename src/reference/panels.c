/* From breaks to panels (see panels.h). */
#include "reference/panels.h"

#include <math.h>
#include <stdlib.h>

static int by_theta(const void *a, const void *b)
{
    double x = ((const struct rl_break *)a)->theta, y = ((const struct rl_break *)b)->theta;
    return (x > y) - (x < y);
}

/* Sorts, and leaves one break where several coincide. */
static size_t merge_breaks(struct rl_break *breaks, size_t n)
{
    size_t kept = 0;
    qsort(breaks, n, sizeof *breaks, by_theta);
    for (size_t i = 0; i < n; i++)
        if (kept == 0 || breaks[i].theta - breaks[kept - 1].theta >= 1e-15)
            breaks[kept++] = breaks[i];
        else if (breaks[i].kind > breaks[kept - 1].kind)
            breaks[kept - 1].kind = breaks[i].kind;
    return kept;
}

/* The next break's index beyond i that ends a panel, going round; `turn` counts times past pi. */
static size_t next_end(const struct rl_break *breaks, size_t n, size_t i, double *turn)
{
    do {
        i++;
        if (i == n) {
            i = 0;
            *turn += RL_PI;
        }
    } while (breaks[i].kind == RL_BREAK_ROOT);
    return i;
}

/* Whether a root lies beyond the panel's end at break i, in steps of +1 or -1, no further than the panel is long; *gap: how far. */
static bool root_beyond(double *gap, const struct rl_break *breaks, size_t n, size_t i, int step,
                        double reach)
{
    double theta = breaks[i].theta, turn = 0.0;
    for (size_t seen = 0; seen < n; seen++) {
        *gap = fabs(breaks[i].theta + turn - theta);
        if (*gap > reach)
            return false;
        if (breaks[i].kind != RL_BREAK_KINK)
            return true;
        if (step > 0 ? i + 1 == n : i == 0)
            turn += step * RL_PI;
        i = step > 0 ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n : i) - 1;
    }
    return false;
}

size_t rl_panels_between(struct rl_panel *panels, struct rl_break *breaks, size_t n_breaks)
{
    n_breaks = merge_breaks(breaks, n_breaks);
    size_t first = 0, n = 0;
    while (first < n_breaks && breaks[first].kind == RL_BREAK_ROOT)
        first++;
    if (first == n_breaks) {
        panels[0] = (struct rl_panel){.a = 0.0, .b = RL_PI};
        return 1;
    }
    size_t i = first;
    do {
        double turn = 0.0;
        size_t to = next_end(breaks, n_breaks, i, &turn);
        struct rl_panel *p = &panels[n++];
        *p = (struct rl_panel){.a = breaks[i].theta, .b = breaks[to].theta + turn};
        p->root_at_a = root_beyond(&p->gap_a, breaks, n_breaks, i, -1, p->b - p->a);
        p->root_at_b = root_beyond(&p->gap_b, breaks, n_breaks, to, 1, p->b - p->a);
        i = to;
    } while (i != first);
    return n;
}
