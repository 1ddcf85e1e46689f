/* Every texel of an environment map (see texel_map.h). */
#include "reference/texel_map.h"

#include <math.h>
#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

#include "base/simd.h"
#include "reference/texel_pole.h"
#include "reference/texel_sum.h"

/* Texels nearer to a pole than this many of their edges get their integral. */
#define REACH_EDGES 8.0

/* The texels that see one radiance. */
struct layer {
    double radiance[3];
    struct rl_texel_list list;
    float *memory; /* x, y, z and solid angle, one behind the other */
};

struct rl_texel_map {
    struct rl_cube_map cube;
    size_t
        n_layers; /* one for each radiance of the set; those that nothing sees, and black ones, are empty */
    struct layer *layer;
    rl_texel_sum *sum;
};

static double centre_of(int index, int size)
{
    return (2 * index + 1.0) / size - 1.0;
}

static int allocate_layers(struct rl_texel_map *map, const size_t *count, struct rl_error *error)
{
    for (size_t i = 0; i < map->n_layers; i++) {
        struct layer *l = &map->layer[i];
        l->memory = malloc((4 * count[i] + 1) * sizeof *l->memory);
        if (!l->memory)
            return rl_fail_memory(error, "the texels of an environment map");
        l->list = (struct rl_texel_list){.x = l->memory,
                                         .y = l->memory + count[i],
                                         .z = l->memory + 2 * count[i],
                                         .solid_angle = l->memory + 3 * count[i]};
    }
    return RL_OK;
}

static void add_texel(struct layer *l, size_t capacity, int face, double s, double t, double half)
{
    rl_vec3 L = v3_normalize(rl_cube_direction(face, s, t));
    float *to = l->memory + l->list.n++;
    to[0] = (float)L.x;
    to[capacity] = (float)L.y;
    to[2 * capacity] = (float)L.z;
    to[3 * capacity] = (float)rl_cube_solid_angle(s, t, half);
}

static bool is_black(const double radiance[3])
{
    return radiance[0] == 0.0 && radiance[1] == 0.0 && radiance[2] == 0.0;
}

/* Counts the texels of each layer, or lists them where there is room. */
static void visit_texels(struct rl_texel_map *map, size_t *count, bool list)
{
    int size = map->cube.size;
    for (int face = 0; face < RL_CUBE_FACES; face++) {
        struct rl_cube_box box = map->cube.lit[face];
        for (int y = box.from[1]; y < box.to[1]; y++) {
            const uint16_t *row = map->cube.seen + ((size_t)face * (size_t)size + (size_t)y) * (size_t)size;
            for (int x = box.from[0]; x < box.to[0]; x++) {
                size_t layer = (size_t)row[x] - 1;
                if (row[x] == 0)
                    continue;
                if (!list)
                    count[layer]++;
                else if (count[layer] > 0)
                    add_texel(&map->layer[layer], count[layer], face, centre_of(x, size), centre_of(y, size),
                              1.0 / size);
            }
        }
    }
}

static int list_texels(struct rl_texel_map *map, size_t *count, struct rl_error *error)
{
    visit_texels(map, count, false);
    for (size_t i = 0; i < map->n_layers; i++)
        if (is_black(map->layer[i].radiance))
            count[i] = 0;
    int status = allocate_layers(map, count, error);
    if (status == RL_OK)
        visit_texels(map, count, true);
    return status;
}

int rl_texel_map_make(struct rl_texel_map **out, const struct rl_light_set *set, rl_vec3 from, int size,
                      struct rl_error *error)
{
    *out = NULL;
    struct rl_texel_map *map = calloc(1, sizeof *map);
    size_t *count = calloc(set->n_radiances + 1, sizeof *count);
    int status = map && count ? RL_OK : rl_fail_memory(error, "an environment map");
    if (status == RL_OK) {
        map->sum = rl_texel_sum_for(rl_simd_best());
        map->layer = calloc(set->n_radiances + 1, sizeof *map->layer);
        status = map->layer ? rl_cube_map_make(&map->cube, set, from, size, error)
                            : rl_fail_memory(error, "an environment map");
    }
    if (status == RL_OK) {
        map->n_layers = set->n_radiances;
        for (size_t i = 0; i < map->n_layers; i++)
            memcpy(map->layer[i].radiance, set->radiance[i], sizeof map->layer[i].radiance);
        status = list_texels(map, count, error);
    }
    free(count);
    if (status != RL_OK) {
        rl_texel_map_free(map);
        return status;
    }
    *out = map;
    return RL_OK;
}

void rl_texel_map_free(struct rl_texel_map *map)
{
    if (!map)
        return;
    for (size_t i = 0; i < map->n_layers; i++)
        free(map->layer[i].memory);
    free(map->layer);
    rl_cube_map_clear(&map->cube);
    free(map);
}

const struct rl_cube_map *rl_texel_map_cube(const struct rl_texel_map *map)
{
    return &map->cube;
}

static struct rl_texel_point texel_point(const struct rl_texel_pole *pole)
{
    const rl_vec3 axes[3] = {pole->frame.T, pole->frame.B, pole->frame.N};
    struct rl_texel_point p = {
        .v = {(float)pole->v.x, (float)pole->v.y, (float)pole->v.z},
        .rr = (float)pole->rr,
        .u_least = (float)(pole->reach * pole->reach),
        .attenuation = pole->attenuation,
    };
    for (int i = 0; i < 3; i++) {
        p.axis[i][0] = (float)axes[i].x;
        p.axis[i][1] = (float)axes[i].y;
        p.axis[i][2] = (float)axes[i].z;
    }
    return p;
}

/* What the texels near a pole add to the sum that held |y| at the reach. */
struct correction {
    const struct rl_texel_map *map;
    const struct rl_texel_pole *pole;
    double *value; /* RGB */
    size_t evaluations;
};

static void correct_texel(struct correction *c, int face, int x, int y)
{
    int size = c->map->cube.size;
    size_t index = ((size_t)face * (size_t)size + (size_t)y) * (size_t)size + (size_t)x;
    unsigned seen = c->map->cube.seen[index];
    if (seen == 0 || c->map->layer[seen - 1].list.n == 0)
        return;
    double half = 1.0 / size, s = centre_of(x, size), t = centre_of(y, size);
    double held = rl_texel_weight(c->pole, face, s, t) * rl_texel_solid_angle(s, t, half);
    double more = rl_texel_integral(c->pole, face, s, t, half, &c->evaluations) - held;
    for (int k = 0; k < 3; k++)
        c->value[k] += more * c->map->layer[seen - 1].radiance[k];
}

/* A rectangle of texels on a face, divided down to the texels that are near. Its centre's |y| says of all of them whether they can
 * be: |y| of two directions differs by no more than they do. */
static void correct(struct correction *c, int face, struct rl_cube_box box)
{
    int size = c->map->cube.size;
    int across = box.to[0] - box.from[0], down = box.to[1] - box.from[1];
    bool texel = across == 1 && down == 1;
    double s = (double)(box.from[0] + box.to[0]) / size - 1.0,
           t = (double)(box.from[1] + box.to[1]) / size - 1.0;
    double spread = texel ? 0.0 : sqrt((double)across * across + (double)down * down) / size;
    if (rl_texel_distance(c->pole, face, s, t) >= c->pole->reach + spread)
        return;
    if (texel) {
        correct_texel(c, face, box.from[0], box.from[1]);
        return;
    }
    int k = down > across, middle = (box.from[k] + box.to[k]) / 2;
    struct rl_cube_box first = box, second = box;
    first.to[k] = second.from[k] = middle;
    correct(c, face, first);
    correct(c, face, second);
}

/* Near is |y| below so many edges of a texel in the mirror direction, whose largest component is what its face's outward one is. */
static double reach_of(const struct rl_surface *surface, int size)
{
    rl_vec3 R = v3_reflect(surface->V, surface->N);
    return REACH_EDGES * 2.0 / size * fmax(fabs(R.x), fmax(fabs(R.y), fabs(R.z)));
}

size_t rl_texel_map_integrate(double value[3], const struct rl_texel_map *map,
                              const struct rl_surface *surface, const struct rl_ellipsoid *e,
                              bool attenuation)
{
    value[0] = value[1] = value[2] = 0.0;
    if (!(v3_dot(surface->N, surface->V) > 0.0))
        return 0;
    int size = map->cube.size;
    struct rl_texel_pole pole = rl_texel_pole_make(surface, e, attenuation, reach_of(surface, size));
    struct rl_texel_point point = texel_point(&pole);
    size_t evaluations = 0;
    for (size_t i = 0; i < map->n_layers; i++) {
        const struct layer *l = &map->layer[i];
        double sum = l->list.n > 0 ? pole.scale * map->sum(&l->list, &point) : 0.0;
        for (int c = 0; c < 3; c++)
            value[c] += sum * l->radiance[c];
        evaluations += l->list.n;
    }
    struct correction correction = {.map = map, .pole = &pole, .value = value};
    for (int face = 0; face < RL_CUBE_FACES && evaluations > 0; face++)
        if (map->cube.lit[face].from[0] < map->cube.lit[face].to[0])
            correct(&correction, face, map->cube.lit[face]);
    return evaluations + correction.evaluations;
}
