/* Which polygons of a light set share an edge: vertices in exactly the same places, as a mesh's triangles have them. */
#include <stdlib.h>

#include "reference/light_set.h"

/* An edge with its ends in a fixed order, so that both its polygons write it alike. */
struct side {
    rl_vec3 low, high;
    size_t edge, polygon;
    bool turned;
};

static int order(rl_vec3 a, rl_vec3 b)
{
    if (a.x != b.x)
        return a.x < b.x ? -1 : 1;
    if (a.y != b.y)
        return a.y < b.y ? -1 : 1;
    return (a.z > b.z) - (a.z < b.z);
}

static int by_place(const void *a, const void *b)
{
    const struct side *x = a, *y = b;
    int low = order(x->low, y->low);
    return low ? low : order(x->high, y->high);
}

static void fill(struct side *side, const struct rl_light_set *set)
{
    for (size_t i = 0; i < set->n_polygons; i++) {
        const struct rl_set_polygon *polygon = &set->polygon[i];
        for (size_t j = 0; j < polygon->n; j++) {
            rl_vec3 a = set->vertex[polygon->first + j],
                    b = set->vertex[polygon->first + (j + 1) % polygon->n];
            bool turned = order(a, b) > 0;
            side[polygon->first + j] = (struct side){
                .low = turned ? b : a,
                .high = turned ? a : b,
                .edge = polygon->first + j,
                .polygon = i,
                .turned = turned,
            };
        }
    }
}

int rl_light_set_find_twins(struct rl_light_set *set, struct rl_error *error)
{
    size_t n = set->n_vertices;
    struct side *side = malloc(n * sizeof *side);
    set->twin = malloc(n * sizeof *set->twin);
    if (!side || !set->twin) {
        free(side);
        return rl_fail_memory(error, "the lights");
    }
    fill(side, set);
    qsort(side, n, sizeof *side, by_place);
    for (size_t i = 0, next; i < n; i = next) {
        for (next = i + 1; next < n && by_place(&side[i], &side[next]) == 0; next++)
            ;
        for (size_t j = i; j < next; j++)
            set->twin[side[j].edge] = (struct rl_twin){.polygon = RL_NO_TWIN};
        const struct side *a = &side[i], *b = &side[i + 1];
        if (next - i != 2 || a->polygon == b->polygon)
            continue;
        set->twin[a->edge] = (struct rl_twin){b->polygon, a->turned != b->turned};
        set->twin[b->edge] = (struct rl_twin){a->polygon, a->turned != b->turned};
    }
    free(side);
    return RL_OK;
}
