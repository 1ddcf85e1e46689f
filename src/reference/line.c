/* One line: its crossings with the lights' edges, the stretches on which a light is seen, and the integral over them (see lines.h). */
#include <float.h>
#include <math.h>
#include <stdint.h>

#include "reference/axes.h"
#include "reference/lines.h"
#include "reference/occlusion.h"

/* A line's own axes, and the closed forms of G along it once they are needed. */
struct line {
    struct rl_axes axes;
    bool has_zones;
    struct rl_inner_line zones;
};

/* Collects the stretches given in order; those of one radiance that touch become one. Each is either added to `value` or written down. */
struct sweep {
    const struct rl_lines *lines;
    struct line *line;
    double *value; /* NULL: written down */
    struct rl_stretch *stretch;
    size_t n, room;
    size_t radiance;          /* what is seen now: an index in the set, or NOTHING */
    struct rl_crossing start; /* from here on */
};
#define NOTHING SIZE_MAX

/* The place where the line's direction is L. */
static struct rl_crossing place(const struct rl_lines *lines, const struct line *line, double l_t, double l_n)
{
    double h_t = line->axes.v_t + l_t, h_n = line->axes.v_n + l_n;
    struct rl_crossing at = {
        .normal = rl_axes_normal(&line->axes, l_t, l_n),
        .l_t = l_t,
        .l_n = l_n,
        .full = !lines->attenuation || 4.0 * h_n * fmin(line->axes.v_n, l_n) >= h_t * h_t + h_n * h_n,
    };
    at.delta = lines->stretch == 1.0 ? at.normal : rl_inner_unstretch(at.normal, lines->stretch);
    return at;
}

/* Where the line's circle crosses the great circle of unit normal m. */
static struct rl_crossing cross(const struct rl_lines *lines, const struct line *line, rl_vec3 m, bool up)
{
    struct rl_on_line L = rl_axes_cross(&line->axes, m, up);
    struct rl_crossing at = place(lines, line, L.t, L.n);
    at.limit = (struct rl_limit){m, up ? 1.0 : -1.0};
    return at;
}

/* The light lies where m.L > 0: upwards the line leaves it. */
static size_t cross_polygon(struct rl_crossing *out, const struct rl_lines *lines, const struct line *line,
                            struct rl_seen_polygon *polygon)
{
    const struct rl_edge *edge = &lines->edge[polygon->first];
    size_t n = 0;
    for (size_t i = 0; i < polygon->n; i++) {
        enum rl_meeting meeting = rl_axes_meet(&line->axes, &edge[i]);
        if (meeting == RL_MEETS_NOT)
            continue;
        out[n] = cross(lines, line, edge[i].m, meeting == RL_MEETS_UPWARDS);
        out[n++].sign = meeting == RL_MEETS_UPWARDS ? -1 : 1;
        if (meeting != RL_MEETS_TWICE)
            continue;
        out[n] = cross(lines, line, edge[i].m, true);
        out[n++].sign = -1;
    }
    for (size_t i = 0; i < n; i++)
        out[i].polygon = polygon;
    return n;
}

/* Below this, on which side of the mirror direction a crossing lies is rounding. */
static const double near_mirror = 1e-9;

/* The least winding at the start with which no more leave than were there; crossings at the mirror direction count as one. */
static int least_winding(const struct rl_crossing *crossing, size_t n)
{
    int least = 0;
    for (size_t i = 0; i < n; i++) {
        int so_far = 0;
        for (size_t j = 0; j < n; j++)
            if (crossing[j].normal.s <= fmax(crossing[i].normal.s, near_mirror) &&
                (crossing[j].normal.s <= crossing[i].normal.s || fabs(crossing[i].normal.s) < near_mirror))
                so_far += crossing[j].sign;
        least = so_far < least ? so_far : least;
    }
    return -least;
}

/* How often the polygon is seen through at delta = -pi/2, from its crossings on this line. */
static int winding_at_start(const struct rl_lines *lines, const struct line *line,
                            const struct rl_seen_polygon *polygon, const struct rl_crossing *crossing,
                            size_t n)
{
    if (lines->attenuation)
        return 0; /* below the horizon */
    /* At delta = 0 the line passes the mirror direction, of which it is known how many polygons it hits. Where an edge lies
     * too near to tell on which side of it that is, the direction at delta = -pi/2 itself is asked about, which all that is
     * left of a mesh cannot answer. */
    int before_mirror = 0;
    double nearest = polygon->mirror_on_edge ? 0.0 : 1.0;
    for (size_t i = 0; i < n; i++) {
        nearest = fmin(nearest, fabs(crossing[i].normal.s));
        before_mirror += crossing[i].normal.s < 0.0 ? crossing[i].sign : 0;
    }
    if (nearest > near_mirror)
        return polygon->mirror_winding - before_mirror;
    if (lines->merged)
        return least_winding(crossing, n);
    rl_vec3 L = {line->axes.cos_theta * line->axes.v_t + line->axes.sin_theta * line->axes.v_b,
                 line->axes.sin_theta * line->axes.v_t - line->axes.cos_theta * line->axes.v_b,
                 -line->axes.v_n};
    return rl_lines_hit(lines, polygon, L);
}

/* Shell sort with Ciura's gaps: crossings are few, and arrive nearly in order. */
static void sort_crossings(struct rl_crossing *crossing, size_t n)
{
    static const size_t gaps[] = {1750, 701, 301, 132, 57, 23, 10, 4, 1};
    for (size_t g = 0; g < sizeof gaps / sizeof gaps[0]; g++)
        for (size_t i = gaps[g]; i < n; i++) {
            struct rl_crossing moved = crossing[i];
            size_t at = i;
            for (; at >= gaps[g] && crossing[at - gaps[g]].normal.s > moved.normal.s; at -= gaps[g])
                crossing[at] = crossing[at - gaps[g]];
            crossing[at] = moved;
        }
}

static double inner_integral(const struct rl_lines *lines, struct line *line, const struct rl_crossing *a,
                             const struct rl_crossing *b)
{
    /* L is in the plane of t and N: its part along t is the sine of its angle from N. */
    if (lines->irradiance)
        return 0.5 * (b->l_t * fabs(b->l_t) - a->l_t * fabs(a->l_t));
    if (a->full && b->full)
        return rl_inner_mass(lines->e, a->delta, b->delta);
    if (!line->has_zones)
        rl_inner_line_make(&line->zones, lines->e, lines->stretch, line->axes.v_t, line->axes.v_n);
    line->has_zones = true;
    return rl_inner_attenuated(&line->zones, lines->e, lines->stretch, a->delta, b->delta);
}

/* What an error of a few units in the last place of the normal's angle does to U, or to half a squared sine. */
static double rounding(const struct rl_lines *lines, const struct rl_crossing *at)
{
    if (lines->irradiance)
        return 8.0 * DBL_EPSILON;
    double density = rl_ellipsoid_pdf_sincos(lines->e, at->delta.s, at->delta.c);
    double l = lines->stretch, lc = l * at->normal.c, s = at->normal.s;
    if (l < 1.0)
        density *= l / fmax(DBL_MIN, lc * lc + s * s);
    return fmin(1.0, 8.0 * DBL_EPSILON * density);
}

/* The crossing whose microfacet normal is given. */
static struct rl_crossing at_normal(const struct rl_lines *lines, const struct line *line,
                                    struct rl_angle normal)
{
    struct rl_on_line L = rl_axes_mirror(&line->axes, normal);
    double twice = 2.0 * (line->axes.v_t * normal.s + line->axes.v_n * normal.c);
    struct rl_crossing at = {.normal = normal, .l_t = L.t, .l_n = L.n};
    at.full = !lines->attenuation || 4.0 * twice * normal.c * fmin(line->axes.v_n, L.n) >= twice * twice;
    at.delta = lines->stretch == 1.0 ? normal : rl_inner_unstretch(normal, lines->stretch);
    return at;
}

/* The inner integral over what of a stretch is not hidden; *off gains what of it is in doubt. */
static double visible_integral(double *off, const struct rl_lines *lines, struct line *line,
                               const struct rl_crossing *a, const struct rl_crossing *b)
{
    const struct rl_part *part = lines->occlusion->part;
    size_t n = rl_occlusion_split(lines->occlusion, lines, line->axes.cos_theta, line->axes.sin_theta,
                                  a->normal, b->normal);
    double sum = 0.0;
    for (size_t i = 0; i < n; i++) {
        struct rl_crossing from = at_normal(lines, line, part[i].from),
                           to = at_normal(lines, line, part[i].to);
        double inner = inner_integral(lines, line, &from, &to);
        sum += part[i].visible ? inner : 0.0;
        *off += (part[i].doubtful ? inner : 0.0) + rounding(lines, &from) + rounding(lines, &to);
    }
    return sum;
}

/* Adds a stretch to the value. */
static void add_stretch(double value[4], const struct rl_lines *lines, struct line *line,
                        const struct rl_crossing *from, const struct rl_crossing *to, size_t radiance)
{
    const struct rl_light_set *set = lines->set;
    double off = rounding(lines, from) + rounding(lines, to);
    double inner = lines->occlusion ? visible_integral(&off, lines, line, from, to)
                                    : inner_integral(lines, line, from, to);
    for (int c = 0; c < 3; c++)
        value[c] += inner * set->radiance[radiance][c];
    value[3] += set->brightest * off;
}

/* From `at` on, light of this radiance is seen. */
static void switch_to(struct sweep *sweep, size_t radiance, const struct rl_crossing *at)
{
    /* Where one light of a radiance takes over from another, its distance changes, and so may what hides it. */
    if (radiance == sweep->radiance && !sweep->lines->occlusion)
        return;
    if (sweep->radiance != NOTHING) {
        if (sweep->value)
            add_stretch(sweep->value, sweep->lines, sweep->line, &sweep->start, at, sweep->radiance);
        else if (sweep->n < sweep->room)
            sweep->stretch[sweep->n] = (struct rl_stretch){sweep->start.limit, at->limit, sweep->radiance};
        sweep->n++;
    }
    sweep->radiance = radiance;
    sweep->start = *at;
}

/* The direction L whose normal halves the angle between the normals at a and b, as place. */
static struct rl_crossing middle(const struct rl_lines *lines, const struct line *line,
                                 const struct rl_crossing *a, const struct rl_crossing *b)
{
    struct rl_on_line L = rl_axes_mirror(&line->axes, rl_angle_middle(a->normal, b->normal));
    return place(lines, line, L.t, L.n);
}

static double nearness(const struct line *line, const struct rl_seen_polygon *polygon,
                       const struct rl_crossing *at)
{
    double w_t = line->axes.cos_theta * polygon->nearness.x + line->axes.sin_theta * polygon->nearness.y;
    double w_b = line->axes.cos_theta * polygon->nearness.y - line->axes.sin_theta * polygon->nearness.x;
    return w_t * at->l_t - w_b * line->axes.v_b + polygon->nearness.z * at->l_n;
}

/* The polygon hit first; of those that hit together, the set's first. */
static struct rl_seen_polygon *nearest(struct rl_seen_polygon *const active[], size_t n,
                                       const struct line *line, const struct rl_crossing *at)
{
    struct rl_seen_polygon *best = active[0];
    double most = nearness(line, best, at);
    for (size_t i = 1; i < n; i++) {
        double near = nearness(line, active[i], at);
        double slack = 1e-13 * fabs(most);
        if (near > most + slack || (near >= most - slack && active[i] < best)) {
            best = active[i];
            most = near;
        }
    }
    return best;
}

/* Several polygons of different radiance between a and b: the nearest is seen. Planes of polygons that pass through one another
 * meet the line in closed form too (their nearness is equal on a great circle), and there the stretch is split. */
static void sweep_overlap(struct sweep *sweep, struct rl_seen_polygon *const active[], size_t n,
                          const struct rl_crossing *a, const struct rl_crossing *b, int depth)
{
    struct rl_crossing mid = middle(sweep->lines, sweep->line, a, b), low = *a, high = *b;
    const struct rl_seen_polygon *seen = nearest(active, n, sweep->line, &mid);
    for (size_t i = 0; i < n && depth > 0; i++) {
        rl_vec3 m = v3_normalize(v3_sub(active[i]->nearness, seen->nearness));
        if (active[i]->radiance == seen->radiance || !(v3_dot(m, m) > 0.0))
            continue;
        for (int up = 0; up < 2; up++) {
            struct rl_crossing at = cross(sweep->lines, sweep->line, m, up);
            if (at.normal.s > low.normal.s && at.normal.s <= mid.normal.s)
                low = at;
            else if (at.normal.s < high.normal.s && at.normal.s > mid.normal.s)
                high = at;
        }
    }
    if (low.normal.s > a->normal.s)
        sweep_overlap(sweep, active, n, a, &low, depth - 1);
    switch_to(sweep, seen->radiance, &low);
    if (high.normal.s < b->normal.s)
        sweep_overlap(sweep, active, n, &high, b, depth - 1);
}

/* What is seen from crossing a to crossing b. */
static void sweep_stretch(struct sweep *sweep, struct rl_seen_polygon *const active[], size_t n,
                          const struct rl_crossing *a, const struct rl_crossing *b)
{
    enum { DEEPEST = 16 };
    if (n == 0) {
        switch_to(sweep, NOTHING, a);
        return;
    }
    for (size_t i = 1; i < n; i++)
        if (active[i]->radiance != active[0]->radiance) {
            if (b->normal.s > a->normal.s)
                sweep_overlap(sweep, active, n, a, b, DEEPEST);
            return;
        }
    switch_to(sweep, active[0]->radiance, a);
}

/* Keeps the list of polygons seen through up to date; any winding but 0 counts as inside. */
static size_t wind(struct rl_seen_polygon *active[], size_t n, struct rl_seen_polygon *polygon, int sign)
{
    int before = polygon->winding;
    polygon->winding += sign;
    if (before == 0 && polygon->winding != 0) {
        active[n++] = polygon;
    } else if (before != 0 && polygon->winding == 0) {
        size_t at = 0;
        while (active[at] != polygon)
            at++;
        active[at] = active[--n];
    }
    return n;
}

static struct line line_at(const struct rl_lines *lines, double theta)
{
    double sin_theta, cos_theta;
    sincos(theta, &sin_theta, &cos_theta);
    return (struct line){.axes = rl_axes_make(lines, cos_theta, sin_theta)};
}

/* delta = -pi/2 or pi/2. */
static struct rl_crossing line_end(const struct rl_lines *lines, const struct line *line, double sign)
{
    return (struct rl_crossing){
        .normal = {sign, 0.0},
        .delta = {sign, 0.0},
        .l_t = line->axes.v_t,
        .l_n = -line->axes.v_n,
        .full = !lines->attenuation,
        .limit = {v3(0.0, 0.0, sign), 0.0},
    };
}

/* Sees the line's stretches in order. */
static void sweep_line(struct sweep *sweep)
{
    const struct rl_lines *lines = sweep->lines;
    struct rl_crossing *crossing = lines->crossing;
    size_t n = 0, n_active = 0;
    for (size_t i = 0; i < lines->n_polygons; i++) {
        struct rl_seen_polygon *polygon = &lines->polygon[i];
        size_t more = cross_polygon(crossing + n, lines, sweep->line, polygon);
        polygon->winding = 0;
        n_active = wind(lines->active, n_active, polygon,
                        winding_at_start(lines, sweep->line, polygon, crossing + n, more));
        n += more;
    }
    if (n == 0 && n_active == 0)
        return;
    sort_crossings(crossing, n);
    const struct rl_crossing first = line_end(lines, sweep->line, -1.0),
                             last = line_end(lines, sweep->line, 1.0);
    sweep_stretch(sweep, lines->active, n_active, &first, n > 0 ? &crossing[0] : &last);
    for (size_t i = 0; i < n; i++) {
        n_active = wind(lines->active, n_active, crossing[i].polygon, crossing[i].sign);
        sweep_stretch(sweep, lines->active, n_active, &crossing[i], i + 1 < n ? &crossing[i + 1] : &last);
    }
    switch_to(sweep, NOTHING, &last);
}

bool rl_lines_integrate(double value[4], const struct rl_lines *lines, double theta)
{
    struct line line = line_at(lines, theta);
    struct sweep sweep = {.lines = lines, .line = &line, .value = value, .radiance = NOTHING};
    value[0] = value[1] = value[2] = value[3] = 0.0;
    sweep_line(&sweep);
    return sweep.n > 0;
}

size_t rl_lines_trace(struct rl_stretch *stretch, size_t room, const struct rl_lines *lines, double theta)
{
    struct line line = line_at(lines, theta);
    struct sweep sweep = {
        .lines = lines, .line = &line, .stretch = stretch, .room = room, .radiance = NOTHING};
    sweep_line(&sweep);
    return sweep.n;
}
