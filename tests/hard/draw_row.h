/* Rows of arguments for a probe: vectors and parameters drawn by draw.h. A row is always one that the probe takes. */
#ifndef RL_TESTS_HARD_DRAW_ROW_H
#define RL_TESTS_HARD_DRAW_ROW_H

#include "hard/draw.h"
#include "probe/probe.h"

static inline double draw_column(struct draw *d, const struct rl_probe_column *c)
{
    if (c->whole && c->high - c->low < 100.0)
        return c->low + (double)draw_below(d, (unsigned)(c->high - c->low) + 1);
    if (c->whole)
        return floor(draw_between(d, c->low, c->high));
    return c->low < c->high ? draw_between(d, c->low, c->high) : draw_any(d, d->single ? 60 : 1000);
}

/* Of parameters that exclude each other (NAN stands for one left out): either the first key, or all others. */
static inline void draw_left_out(struct draw *d, const struct rl_probe *p, double *row)
{
    size_t first = p->n_in, alone = 0;
    for (size_t i = p->n_in; i-- > 0;)
        first = p->in[i].optional ? i : first;
    if (first == p->n_in)
        return;
    /* The first key has three columns where it is a colour. */
    const char *name = p->in[first].name;
    size_t length = strlen(name);
    alone = length > 2 && strcmp(name + length - 2, "_r") == 0 ? 3 : 1;
    bool one = draw_below(d, 2);
    for (size_t i = first; i < p->n_in; i++)
        if (p->in[i].optional && one == (i >= first + alone))
            row[i] = NAN;
}

/* A polygon's vertices: near the horizon, on it, near P, far away, or one beside the other. */
static inline void draw_vertices(struct draw *d, double *row, size_t n_vectors)
{
    /* Coordinates of scenes end at 1e9; in C squares of areas are numbers. */
    int reach = d->single ? 20 : 200;
    double scale = draw_below(d, 2) ? 1.0 : draw_exponent(d, -reach, reach);
    for (size_t v = 2; v < n_vectors; v++) {
        const double *before = row + 3 * v - 3;
        bool beside = v > 2 && draw_below(d, 4) == 0;
        for (int c = 0; c < 3; c++) {
            double x = beside ? before[c] + scale * draw_signed_exponent(d, -40, 0) : scale * draw_any(d, 8);
            row[3 * v + (size_t)c] = d->single ? (double)(float)x : x;
        }
    }
}

static inline void draw_row(struct draw *d, const struct rl_probe *p, double *row)
{
    rl_vec3 v[3] = {{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
    for (size_t i = 0; i < p->n_directions; i++) {
        v[i] = i == 0 ? draw_direction(d) : draw_related(d, v[0], i == 1 ? v3(0.1, -0.7, 0.4) : v[1]);
        row[3 * i] = v[i].x;
        row[3 * i + 1] = v[i].y;
        row[3 * i + 2] = v[i].z;
    }
    for (size_t i = 3 * p->n_directions; i < p->n_in; i++)
        row[i] = draw_column(d, &p->in[i]);
    if (p->polygon)
        draw_vertices(d, row, p->n_vectors);
    draw_left_out(d, p, row);
}

#endif
