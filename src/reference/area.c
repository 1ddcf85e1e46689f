/* Cuts light polygons into cells (see area.h). */
#include "reference/area.h"

#include <float.h>
#include <stdlib.h>

/* Borders this close together, in parts of their distance from the apex, or in radians, enclose nothing. */
#define THIN 1e-14
/* An apex farther from the polygon's middle than this many of its radii makes no pole that matters. */
#define APEX_REACH 4.0

struct segment {
    struct rl_point2 a, b;
};

/* Growing arrays; `failed` remembers a lack of memory, after which nothing is added. */
struct work {
    const struct rl_cast *cast;
    const struct rl_surface *surface;
    bool attenuation, failed;
    size_t polygon;
    struct rl_point2 middle;
    double radius; /* of a disc about `middle` that holds the outline */
    size_t n_apices;
    struct rl_point2 apex[2];
    size_t n_segments, segment_room, n_points, point_room, n_angles, angle_room, n_crossings, crossing_room;
    struct segment *segment;
    struct rl_point2 *point;
    double *angle;
    struct crossing *crossing;
};

/* Where a segment crosses a wedge: distances from the apex at the wedge's middle and along its two sides. */
struct crossing {
    double middle, from, to;
};

static bool grow(void **array, size_t *room, size_t n, size_t size, bool *failed)
{
    if (*failed || n < *room)
        return !*failed;
    size_t more = 2 * *room + 64;
    void *grown = realloc(*array, more * size);
    *failed = !grown;
    if (grown) {
        *array = grown;
        *room = more;
    }
    return grown != NULL;
}

static struct rl_point2 minus(struct rl_point2 a, struct rl_point2 b)
{
    return (struct rl_point2){a.x - b.x, a.y - b.y};
}

static struct rl_point2 mix(struct rl_point2 a, double t, struct rl_point2 b)
{
    return (struct rl_point2){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

static double cross2(struct rl_point2 a, struct rl_point2 b)
{
    return a.x * b.y - a.y * b.x;
}

static double length2(struct rl_point2 a)
{
    return hypot(a.x, a.y);
}

static void add_point(struct work *w, struct rl_point2 p)
{
    if (grow((void **)&w->point, &w->point_room, w->n_points, sizeof *w->point, &w->failed))
        w->point[w->n_points++] = p;
}

/* Only what reaches into the polygon's disc can border a cell. */
static void add_segment(struct work *w, struct rl_point2 a, struct rl_point2 b)
{
    struct rl_point2 d = minus(b, a), to_middle = minus(w->middle, a);
    double dd = d.x * d.x + d.y * d.y;
    double t = dd > 0.0 ? fmin(1.0, fmax(0.0, (d.x * to_middle.x + d.y * to_middle.y) / dd)) : 0.0;
    if (length2(minus(mix(a, t, b), w->middle)) > 1.01 * w->radius)
        return;
    if (grow((void **)&w->segment, &w->segment_room, w->n_segments, sizeof *w->segment, &w->failed))
        w->segment[w->n_segments++] = (struct segment){a, b};
    add_point(w, a);
    add_point(w, b);
}

/* The line of the points X of the plane, relative to P, with m.X = c, as far as the disc reaches. */
static void add_line(struct work *w, rl_vec3 m, double c)
{
    const struct rl_cast_polygon *polygon = &w->cast->polygon[w->polygon];
    struct rl_point2 n = {v3_dot(m, polygon->T), v3_dot(m, polygon->B)};
    double length = length2(n);
    if (!(length > 1e-12))
        return; /* parallel planes */
    n = (struct rl_point2){n.x / length, n.y / length};
    double off = (c - v3_dot(m, polygon->origin)) / length - (n.x * w->middle.x + n.y * w->middle.y);
    if (fabs(off) > w->radius)
        return;
    struct rl_point2 foot = {w->middle.x + off * n.x, w->middle.y + off * n.y};
    double reach = 2.0 * w->radius;
    add_segment(w, (struct rl_point2){foot.x - reach * n.y, foot.y + reach * n.x},
                (struct rl_point2){foot.x + reach * n.y, foot.y - reach * n.x});
}

/* Where direction X from P meets the plane, in its axes; false if it does not. */
static bool project(struct rl_point2 *out, const struct rl_cast_polygon *polygon, rl_vec3 X)
{
    double t = polygon->distance / v3_dot(polygon->normal, X);
    if (!(t > 0.0 && t < DBL_MAX))
        return false;
    rl_vec3 d = v3_sub(v3_scale(t, X), polygon->origin);
    *out = (struct rl_point2){v3_dot(polygon->T, d), v3_dot(polygon->B, d)};
    return true;
}

/* The edge from p to q, relative to P, projected from P: its part on the far side of a plane parallel to the polygon's, so close to
 * P that what is cut off lies beyond the polygon's farthest corner. */
static void add_projected(struct work *w, rl_vec3 p, rl_vec3 q)
{
    const struct rl_cast_polygon *polygon = &w->cast->polygon[w->polygon];
    rl_vec3 d = v3_sub(q, p);
    double dd = v3_dot(d, d), t = dd > 0.0 ? fmin(1.0, fmax(0.0, -v3_dot(p, d) / dd)) : 0.0;
    double closest = v3_length(v3_madd(p, t, d));
    double farthest = v3_length(polygon->origin) + length2(w->middle) + 2.0 * w->radius;
    double least = 0.5 * closest / farthest;
    double p_depth = v3_dot(polygon->normal, p) / polygon->distance,
           q_depth = v3_dot(polygon->normal, q) / polygon->distance;
    if (!(least > 0.0) || (p_depth < least && q_depth < least))
        return;
    if (p_depth < least)
        p = v3_madd(p, (least - p_depth) / (q_depth - p_depth), d);
    else if (q_depth < least)
        q = v3_madd(p, (least - p_depth) / (q_depth - p_depth), d);
    struct rl_point2 a, b;
    if (project(&a, polygon, p) && project(&b, polygon, q))
        add_segment(w, a, b);
}

static rl_vec3 outline_point(const struct rl_cast_polygon *polygon, size_t i)
{
    struct rl_point2 v = polygon->vertex[i % polygon->n];
    return v3_madd(v3_madd(polygon->origin, v.x, polygon->T), v.y, polygon->B);
}

/* Outline of another polygon, and where its plane passes through this one; nothing if it lies quite elsewhere. */
static void add_other(struct work *w, const struct rl_cast_polygon *other)
{
    const struct rl_cast_polygon *polygon = &w->cast->polygon[w->polygon];
    struct rl_point2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY}, p;
    bool bounded = true;
    for (size_t i = 0; i < other->n; i++)
        if (project(&p, polygon, outline_point(other, i))) {
            low = (struct rl_point2){fmin(low.x, p.x), fmin(low.y, p.y)};
            high = (struct rl_point2){fmax(high.x, p.x), fmax(high.y, p.y)};
        } else {
            bounded = false;
        }
    double reach = 1.01 * w->radius;
    if (bounded && (low.x > w->middle.x + reach || high.x < w->middle.x - reach ||
                    low.y > w->middle.y + reach || high.y < w->middle.y - reach))
        return;
    for (size_t i = 0; i < other->n; i++)
        add_projected(w, outline_point(other, i), outline_point(other, i + 1));
    add_line(w, other->normal, other->distance);
}

static void find_apices(struct work *w)
{
    const struct rl_cast_polygon *polygon = &w->cast->polygon[w->polygon];
    rl_vec3 V = w->surface->V, pole[2] = {v3_reflect(V, w->surface->N), v3_scale(-1.0, V)};
    for (int i = 0; i < (w->attenuation ? 1 : 2); i++) {
        struct rl_point2 at;
        if (project(&at, polygon, pole[i]) && length2(minus(at, w->middle)) < APEX_REACH * w->radius)
            w->apex[w->n_apices++] = at;
    }
    if (w->n_apices == 0)
        w->apex[w->n_apices++] = w->middle;
    if (w->n_apices < 2)
        return;
    /* Between the two. */
    struct rl_point2 n = minus(w->apex[1], w->apex[0]), half = mix(w->apex[0], 0.5, w->apex[1]);
    rl_vec3 m = v3_madd(v3_scale(n.x, polygon->T), n.y, polygon->B);
    rl_vec3 X = v3_madd(v3_madd(polygon->origin, half.x, polygon->T), half.y, polygon->B);
    m = v3_normalize(m);
    add_line(w, m, v3_dot(m, X));
}

static void add_meetings(struct work *w)
{
    for (size_t i = 0; i < w->n_segments; i++)
        for (size_t j = 0; j < i; j++) {
            struct segment p = w->segment[i], q = w->segment[j];
            struct rl_point2 d = minus(p.b, p.a), between = minus(q.a, p.a), e = minus(q.b, q.a);
            double under = cross2(d, e);
            double t = cross2(between, e) / under, r = cross2(between, d) / under;
            if (t > 0.0 && t < 1.0 && r > 0.0 && r < 1.0)
                add_point(w, mix(p.a, t, p.b));
        }
}

static void add_borders(struct work *w)
{
    const struct rl_cast_polygon *polygon = &w->cast->polygon[w->polygon];
    w->middle = mix(polygon->low, 0.5, polygon->high);
    w->radius = 0.5 * length2(minus(polygon->high, polygon->low));
    w->n_apices = w->n_segments = w->n_points = 0;
    for (size_t i = 0; i < polygon->n; i++)
        add_segment(w, polygon->vertex[i], polygon->vertex[(i + 1) % polygon->n]);
    for (size_t i = 0; i < w->cast->n_polygons; i++)
        if (i != w->polygon && w->cast->polygon[i].distance != 0.0)
            add_other(w, &w->cast->polygon[i]);
    if (w->attenuation)
        add_line(w, w->surface->N, 0.0);
    find_apices(w);
    add_meetings(w);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Where the ray from the apex in direction d crosses the segment (relative to the apex); what rounding puts beyond an end is put
 * back there. */
static double distance_along(struct segment seg, struct rl_point2 d)
{
    double a = cross2(d, seg.a), b = cross2(d, seg.b);
    double t = a != b ? fmin(1.0, fmax(0.0, a / (a - b))) : 0.5;
    struct rl_point2 p = mix(seg.a, t, seg.b);
    return p.x * d.x + p.y * d.y;
}

static struct rl_point2 direction(double angle)
{
    return (struct rl_point2){cos(angle), sin(angle)};
}

static void find_crossings(struct work *w, struct rl_point2 apex, double from, double to)
{
    struct rl_point2 d = direction(0.5 * (from + to)), d_from = direction(from), d_to = direction(to);
    w->n_crossings = 0;
    for (size_t i = 0; i < w->n_segments; i++) {
        struct segment seg = {minus(w->segment[i].a, apex), minus(w->segment[i].b, apex)};
        if ((cross2(d, seg.a) > 0.0) == (cross2(d, seg.b) > 0.0))
            continue;
        double middle = distance_along(seg, d);
        if (middle > 0.0 &&
            grow((void **)&w->crossing, &w->crossing_room, w->n_crossings, sizeof *w->crossing, &w->failed))
            w->crossing[w->n_crossings++] = (struct crossing){middle, fmax(0.0, distance_along(seg, d_from)),
                                                              fmax(0.0, distance_along(seg, d_to))};
    }
    /* `middle` stands first. */
    if (w->n_crossings > 0)
        qsort(w->crossing, w->n_crossings, sizeof *w->crossing, ascending);
}

/* Whether this polygon is what is seen at the point, above the horizon if that counts, and nearer to this apex than to the other. */
static bool belongs(const struct work *w, struct rl_point2 at, size_t apex)
{
    const struct rl_cast_polygon *polygon = &w->cast->polygon[w->polygon];
    rl_vec3 X = v3_madd(v3_madd(polygon->origin, at.x, polygon->T), at.y, polygon->B);
    if (w->n_apices == 2 && length2(minus(at, w->apex[1 - apex])) < length2(minus(at, w->apex[apex])))
        return false;
    if (w->attenuation && !(v3_dot(w->surface->N, X) > 0.0))
        return false;
    return rl_cast_nearest(w->cast, X) == w->polygon;
}

static void cut_wedge(struct rl_area *area, struct work *w, size_t apex, double from, double to)
{
    find_crossings(w, w->apex[apex], from, to);
    struct rl_point2 d = direction(0.5 * (from + to)), d_from = direction(from), d_to = direction(to);
    struct crossing near = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < w->n_crossings; i++) {
        struct crossing far = w->crossing[i];
        if (!(far.middle - near.middle > THIN * far.middle))
            continue;
        double half = 0.5 * (near.middle + far.middle);
        struct rl_point2 at = {w->apex[apex].x + half * d.x, w->apex[apex].y + half * d.y};
        if (belongs(w, at, apex) &&
            grow((void **)&area->cell, &area->room, area->n, sizeof *area->cell, &w->failed))
            area->cell[area->n++] = (struct rl_area_cell){
                .polygon = w->polygon,
                .apex = w->apex[apex],
                .from = {far.from * d_from.x, far.from * d_from.y},
                .to = {far.to * d_to.x, far.to * d_to.y},
                .near_from = far.from > 0.0 ? fmin(1.0, near.from / far.from) : 0.0,
                .near_to = far.to > 0.0 ? fmin(1.0, near.to / far.to) : 0.0,
            };
        near = far;
    }
}

static void cut_polygon(struct rl_area *area, struct work *w)
{
    add_borders(w);
    for (size_t k = 0; k < w->n_apices; k++) {
        w->n_angles = 0;
        for (size_t i = 0; i < w->n_points; i++) {
            struct rl_point2 d = minus(w->point[i], w->apex[k]);
            if (grow((void **)&w->angle, &w->angle_room, w->n_angles, sizeof *w->angle, &w->failed))
                w->angle[w->n_angles++] = atan2(d.y, d.x);
        }
        if (w->failed || w->n_angles == 0)
            return;
        qsort(w->angle, w->n_angles, sizeof *w->angle, ascending);
        for (size_t i = 0; i < w->n_angles; i++) {
            double to = i + 1 < w->n_angles ? w->angle[i + 1] : w->angle[0] + 2.0 * RL_PI;
            if (to - w->angle[i] > THIN)
                cut_wedge(area, w, k, w->angle[i], to);
        }
    }
}

int rl_area_make(struct rl_area *area, const struct rl_cast *cast, const struct rl_surface *surface,
                 bool attenuation, struct rl_error *error)
{
    *area = (struct rl_area){0};
    struct work w = {.cast = cast, .surface = surface, .attenuation = attenuation};
    for (size_t i = 0; i < cast->n_polygons && !w.failed; i++)
        if (cast->polygon[i].distance != 0.0) {
            w.polygon = i;
            cut_polygon(area, &w);
        }
    free(w.segment);
    free(w.point);
    free(w.angle);
    free(w.crossing);
    if (!w.failed)
        return RL_OK;
    rl_area_free(area);
    return rl_fail_memory(error, "the cells of the lights");
}

void rl_area_free(struct rl_area *area)
{
    free(area->cell);
    *area = (struct rl_area){0};
}
