/* Whether the triangles of a light enclose a body: only then does the word outside mean anything. */
#include <stdlib.h>

#include "scene/scene.h"

/* Files have a vertex several times, with a normal each, and a sphere's pole as many times as meridians meet there, give or take rounding:
 * what is closer than this part of the light's radius is one vertex. */
#define SAME_PLACE 1e-6

/* A corner of a triangle; corners at one place get one number. */
struct corner {
    double along; /* the direction below */
    rl_vec3 p;
    size_t index, number;
};

/* Not longer than 1, and slanted so that it meets no plane of a mesh that somebody drew: few corners are at the same distance along it. */
static const rl_vec3 slanted = {0.48132517, 0.76421843, 0.42927463};

static int by_distance(const void *a, const void *b)
{
    const struct corner *p = a, *q = b;
    return (p->along > q->along) - (p->along < q->along);
}

static int by_index(const void *a, const void *b)
{
    const struct corner *p = a, *q = b;
    return (p->index > q->index) - (p->index < q->index);
}

static void number_corners(struct corner *corner, size_t n, double same)
{
    qsort(corner, n, sizeof *corner, by_distance);
    for (size_t i = 0; i < n; i++) {
        corner[i].number = i;
        for (size_t j = i; j-- > 0 && corner[i].along - corner[j].along <= same;)
            if (v3_length(v3_sub(corner[i].p, corner[j].p)) <= same) {
                corner[i].number = corner[j].number;
                break;
            }
    }
    qsort(corner, n, sizeof *corner, by_index);
}

struct edge {
    size_t low, high;
};

static int by_ends(const void *a, const void *b)
{
    const struct edge *p = a, *q = b;
    int order = (p->low > q->low) - (p->low < q->low);
    return order ? order : (p->high > q->high) - (p->high < q->high);
}

/* Every edge is there an even number of times; edges without length do not count. Edges that are not make rings, since a triangle brings two
 * edges to each of its corners: there are three of them or more, so looking at pairs finds one. */
static bool in_pairs(struct edge *edge, const struct corner *corner, size_t n_triangles)
{
    size_t n = 0;
    for (size_t i = 0; i < 3 * n_triangles; i++) {
        size_t a = corner[i].number, b = corner[i % 3 < 2 ? i + 1 : i - 2].number;
        if (a != b)
            edge[n++] = (struct edge){a < b ? a : b, a < b ? b : a};
    }
    qsort(edge, n, sizeof *edge, by_ends);
    for (size_t i = 0; i + 1 < n; i += 2)
        if (by_ends(&edge[i], &edge[i + 1]) != 0)
            return false;
    return true;
}

int rl_light_closed(bool *closed, const struct rl_light *light, struct rl_error *error)
{
    size_t n = 3 * light->n_polygons;
    struct corner *corner = malloc((n + 1) * sizeof *corner);
    struct edge *edge = malloc((n + 1) * sizeof *edge);
    int status = corner && edge ? RL_OK : rl_fail_memory(error, "a light's edges");
    if (status == RL_OK) {
        for (size_t i = 0; i < n; i++) {
            rl_vec3 p = light->polygon[i / 3].vertex[i % 3];
            corner[i] = (struct corner){v3_dot(slanted, p), p, i, 0};
        }
        number_corners(corner, n, SAME_PLACE * light->radius);
        *closed = in_pairs(edge, corner, light->n_polygons);
    }
    free(corner);
    free(edge);
    return status;
}
