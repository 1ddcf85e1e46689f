/* Walks the lights' outlines over a cube map (see texel_edges.h). */
#include "reference/texel_edges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference/cube_map.h"

struct walk {
    struct rl_texel_edges *edges;
    int size, face;
    uint32_t polygon;
    size_t n;
    rl_vec3 *vertex, *clipped, *scratch; /* on the face's axes */
    uint32_t *last;                      /* 1 + the polygon that noted this texel last */
    bool out_of_memory;
};

/* Cuts the polygon `from` by the plane normal.v >= 0 through the eye point (Sutherland and Hodgman 1974). */
static size_t cut(rl_vec3 *to, const rl_vec3 *from, size_t n, rl_vec3 normal)
{
    size_t kept = 0;
    for (size_t i = 0; i < n; i++) {
        rl_vec3 a = from[i], b = from[i + 1 < n ? i + 1 : 0];
        double at_a = v3_dot(normal, a), at_b = v3_dot(normal, b);
        if (at_a >= 0.0)
            to[kept++] = a;
        if ((at_a >= 0.0) != (at_b >= 0.0))
            to[kept++] = v3_madd(a, at_a / (at_a - at_b), v3_sub(b, a));
    }
    return kept;
}

static double coverage(const struct walk *w, int x, int y)
{
    double edge = 2.0 / w->size, s = x * edge - 1.0, t = y * edge - 1.0;
    const rl_vec3 sides[4] = {v3(1.0, 0.0, -s), v3(-1.0, 0.0, s + edge), v3(0.0, 1.0, -t),
                              v3(0.0, -1.0, t + edge)};
    const rl_vec3 *from = w->vertex;
    size_t n = w->n;
    for (int i = 0; i < 4; i++) {
        rl_vec3 *to = i % 2 ? w->scratch : w->clipped;
        n = cut(to, from, n, sides[i]);
        from = to;
    }
    double doubled = 0.0;
    for (size_t i = 0; i < n; i++) {
        rl_vec3 a = from[i], b = from[i + 1 < n ? i + 1 : 0];
        if (!(a.z > 0.0) || !(b.z > 0.0))
            return 1.0; /* through the eye point itself */
        doubled += (a.x / a.z - s) * (b.y / b.z - t) - (a.y / a.z - t) * (b.x / b.z - s);
    }
    return fmin(1.0, 0.5 * fabs(doubled) / (edge * edge));
}

static void note(struct walk *w, int x, int y)
{
    size_t index = ((size_t)w->face * (size_t)w->size + (size_t)y) * (size_t)w->size + (size_t)x;
    struct rl_texel_edges *e = w->edges;
    if (w->out_of_memory || w->last[index] == w->polygon + 1)
        return;
    w->last[index] = w->polygon + 1;
    if (e->n == e->capacity) {
        size_t capacity = 2 * e->capacity + 256;
        struct rl_texel_edge *more = realloc(e->edge, capacity * sizeof *more);
        w->out_of_memory = !more;
        if (!more)
            return;
        e->edge = more;
        e->capacity = capacity;
    }
    e->edge[e->n++] = (struct rl_texel_edge){(uint32_t)index, w->polygon, coverage(w, x, y)};
}

static int column_of(const struct walk *w, double x)
{
    return x <= 0.0 ? 0 : x >= w->size ? w->size - 1 : (int)x;
}

/* Every texel that the stretch from a to b passes through: row by row, from where it enters the row to where it leaves. */
static void walk_edge(struct walk *w, rl_vec3 a, rl_vec3 b)
{
    rl_vec3 ends[2] = {a, b}, cuts[2] = {a, b};
    const rl_vec3 sides[4] = {v3(1.0, 0.0, 1.0), v3(-1.0, 0.0, 1.0), v3(0.0, 1.0, 1.0), v3(0.0, -1.0, 1.0)};
    for (int i = 0; i < 4; i++) {
        double at_a = v3_dot(sides[i], ends[0]), at_b = v3_dot(sides[i], ends[1]);
        if (at_a < 0.0 && at_b < 0.0)
            return;
        rl_vec3 middle = v3_madd(ends[0], at_a / (at_a - at_b), v3_sub(ends[1], ends[0]));
        cuts[0] = at_a < 0.0 ? middle : ends[0];
        cuts[1] = at_b < 0.0 ? middle : ends[1];
        memcpy(ends, cuts, sizeof ends);
    }
    if (!(ends[0].z > 0.0) || !(ends[1].z > 0.0))
        return;
    double scale = 0.5 * w->size;
    double x0 = scale * (ends[0].x / ends[0].z + 1.0), y0 = scale * (ends[0].y / ends[0].z + 1.0);
    double x1 = scale * (ends[1].x / ends[1].z + 1.0), y1 = scale * (ends[1].y / ends[1].z + 1.0);
    int first = column_of(w, fmin(y0, y1)), last = column_of(w, fmax(y0, y1));
    for (int row = first; row <= last; row++) {
        double from = first == last ? 0.0 : fmin(1.0, fmax(0.0, (row - y0) / (y1 - y0)));
        double to = first == last ? 1.0 : fmin(1.0, fmax(0.0, (row + 1 - y0) / (y1 - y0)));
        double xa = x0 + from * (x1 - x0), xb = x0 + to * (x1 - x0);
        for (int x = column_of(w, fmin(xa, xb)); x <= column_of(w, fmax(xa, xb)); x++)
            note(w, x, row);
    }
}

static void walk_polygon(struct walk *w, const struct rl_light_set *set, rl_vec3 from)
{
    const struct rl_set_polygon *polygon = &set->polygon[w->polygon];
    w->n = polygon->n;
    for (w->face = 0; w->face < RL_CUBE_FACES; w->face++) {
        for (size_t k = 0; k < w->n; k++)
            w->vertex[k] = rl_cube_on_face(w->face, v3_sub(set->vertex[polygon->first + k], from));
        for (size_t k = 0; k < w->n; k++)
            walk_edge(w, w->vertex[k], w->vertex[k + 1 < w->n ? k + 1 : 0]);
    }
}

int rl_texel_edges_find(struct rl_texel_edges *edges, const struct rl_light_set *set, rl_vec3 from, int size,
                        struct rl_error *error)
{
    *edges = (struct rl_texel_edges){0};
    /* Each of the four planes may add as many vertices as the polygon has edges. */
    size_t most = 1;
    for (size_t i = 0; i < set->n_polygons; i++)
        most = set->polygon[i].n > most ? set->polygon[i].n : most;
    struct walk w = {.edges = edges,
                     .size = size,
                     .vertex = malloc(most * sizeof *w.vertex),
                     .clipped = malloc(16 * most * sizeof *w.clipped),
                     .scratch = malloc(16 * most * sizeof *w.scratch),
                     .last = calloc(RL_CUBE_FACES * (size_t)size * (size_t)size, sizeof *w.last)};
    w.out_of_memory = !w.vertex || !w.clipped || !w.scratch || !w.last;
    for (; w.polygon < set->n_polygons && !w.out_of_memory; w.polygon++)
        walk_polygon(&w, set, from);
    free(w.vertex);
    free(w.clipped);
    free(w.scratch);
    free(w.last);
    if (!w.out_of_memory)
        return RL_OK;
    rl_texel_edges_clear(edges);
    return rl_fail_memory(error, "the edges in an environment map");
}

void rl_texel_edges_clear(struct rl_texel_edges *edges)
{
    free(edges->edge);
    *edges = (struct rl_texel_edges){0};
}
