/* Lambert's diffuse reflection of polygon lights by their exact irradiance, and of point and parallel lights as the effect `diffuse`.
 *
 * A polygon of radiance 1 with vertices v_i as seen from P, all above the horizon N.v >= 0, gives the irradiance (Lambert 1760)
 *
 *     E = | 1/2 sum over edges of  angle_i (gamma_i . N) |,   gamma_i = (v_i x v_i+1)/|v_i x v_i+1|,   angle_i between v_i and v_i+1
 *
 * and k_d E/pi comes back. The sum changes its sign with the winding: lights shine from both sides, so its size counts.
 *
 * What is below the horizon is cut off: an edge keeps its part above, and what closes the polygon along the horizon are edges like others.
 * All crossings lie on one line, the polygon's plane cut by the horizon, so that edges from the first crossing to the others may be added
 * with signs: those where the outline comes up count as ends, those where it goes down as beginnings. So no list of vertices is made, and a
 * polygon may be concave and cross often.
 *
 * Edges of a small light nearly cancel. With f (a x b) for angle gamma, f = angle/|a x b|, and any r,
 *
 *     sum of f (a x b) = (1/r^2) sum of (a x b) + sum of (f - 1/r^2)(a x b),    sum of (a x b) = twice the area, along the normal
 *
 * the first sum does not depend on where P is and comes from differences of vertices; and where r is the distance of the farthest point,
 * f - 1/r^2 = ((g - 1) r^2 + r (r - |a|) + |a| (r - |b|))/(r^2 |a||b|) with g = angle/sin(angle) is small with the light, so that both sums
 * keep their relative precision. What still cancels is a light in a plane through the horizon, seen edge on from all sides: its irradiance
 * has an error of 1e-17.
 *
 * P on an edge's line has no gamma there and the angle 0 or pi: such edges give 0. P in the polygon's plane, as far as the coordinates'
 * rounding lets one know, receives nothing: the sum would be that of one side of the plane, or of the other (model/plane.h).
 *
 * Polygons of a closed mesh count half: a ray into a convex body meets two of its faces (src/scene/seen_lights.c). */
#include "effects/lambert.h"
#include "model/plane.h"

/* A polygon as P sees it: what is above the horizon, edge by edge. Irradiance has no unit of length: coordinates times `down`, a power of two
 * that is less than 1 where they are so large that differences may overflow, differences times `up` as well, so that they are about 1. */
struct outline {
    rl_vec3 P, N; /* P: times down */
    const rl_vec3 *vertex;
    int n;
    double down, up;
};

static double farthest(const rl_vec3 *vertex, int n, rl_vec3 P, double scale)
{
    double most = 0.0;
    for (int i = 0; i < n; i++) {
        rl_vec3 d = v3_sub(v3_scale(scale, vertex[i]), v3_scale(scale, P));
        most = fmax(most, fmax(fabs(d.x), fmax(fabs(d.y), fabs(d.z))));
    }
    return most;
}

static struct outline outline_of(const struct rl_surface *s, const rl_vec3 *vertex, int n)
{
    const double large = 0x1p1000;
    double most = farthest(vertex, n, s->P, 1.0), down = most < large ? 1.0 : 0x1p-1020;
    most = down < 1.0 ? farthest(vertex, n, s->P, down) : most;
    /* The inverse is a number, too. */
    int e = most > 0.0 ? ilogb(most) : 0;
    return (struct outline){v3_scale(down, s->P), s->N, vertex, n, down, ldexp(1.0, e < -1020 ? 1020 : -e)};
}

static rl_vec3 vertex_of(const struct outline *o, int i)
{
    return v3_scale(o->down, o->vertex[i]);
}

static rl_vec3 difference(const struct outline *o, rl_vec3 a, rl_vec3 b)
{
    return v3_scale(o->up, v3_sub(a, b));
}

/* The part of an edge that is above the horizon: its ends from P and from the light's own point of reference, and one end to the other,
 * without a difference of what is far from P. */
struct part {
    rl_vec3 a, b, a_ref, b_ref, along;
    double gamma_N; /* gamma . N, known by the whole edge also where its part passes near P */
    bool up, down;  /* it begins or ends on the horizon, where the edge crosses it */
};

/* The i-th edge's, or false: none of it is. */
static bool part_of_edge(struct part *e, const struct outline *o, int i, rl_vec3 ref)
{
    rl_vec3 from = vertex_of(o, i > 0 ? i - 1 : o->n - 1), to = vertex_of(o, i),
            edge = difference(o, to, from);
    *e = (struct part){.a = difference(o, from, o->P),
                       .b = difference(o, to, o->P),
                       .a_ref = difference(o, from, ref),
                       .b_ref = difference(o, to, ref),
                       .along = edge};
    /* a x b = a x (b - a) = b x (b - a): nothing cancels, nor, by the shorter one, where one end is near. */
    rl_vec3 gamma = v3_normalize(v3_cross(v3_dot(e->a, e->a) < v3_dot(e->b, e->b) ? e->a : e->b, edge));
    e->gamma_N = v3_dot(o->N, gamma);
    double z_a = v3_dot(o->N, e->a), z_b = v3_dot(o->N, e->b);
    e->up = !(z_a > 0.0);
    e->down = !(z_b > 0.0);
    if (e->up && e->down)
        return false;
    if (!e->up && !e->down)
        return true;
    /* |z_b| a + |z_a| b: both terms have one sign in z. */
    double t = fabs(z_a) / (fabs(z_a) + fabs(z_b)), rest = fabs(z_b) / (fabs(z_a) + fabs(z_b));
    rl_vec3 crossing = v3_madd(v3_scale(rest, e->a), t, e->b);
    rl_vec3 crossing_ref = t < 0.5 ? v3_madd(e->a_ref, t, edge) : v3_madd(e->b_ref, -rest, edge);
    if (e->up) {
        e->a = crossing;
        e->a_ref = crossing_ref;
        e->along = v3_scale(rest, edge);
    } else {
        e->b = crossing;
        e->b_ref = crossing_ref;
        e->along = v3_scale(t, edge);
    }
    return true;
}

/* theta/sin(theta) - 1 for sin(theta) up to 1/2 and theta up to pi/6: asin's series. */
static double excess_of_arc(double sine)
{
    double ss = sine * sine, term = 1.0, sum = 0.0;
    for (int k = 1; k < 24; k++) {
        /* (2k - 1)!!/(2k)!! sine^2k */
        term *= ss * (2 * k - 1) / (2 * k);
        sum += term / (2 * k + 1);
    }
    return sum;
}

/* (f - 1/r^2) (a x b).N with f (a x b) = angle gamma, for |ref| = r. */
static double edge_term(const struct part *e, rl_vec3 ref, double r)
{
    double l_a = v3_length(e->a), l_b = v3_length(e->b);
    rl_vec3 across = v3_cross(l_a < l_b ? e->a : e->b, e->along);
    double size = v3_length(across), cosine = v3_dot(e->a, e->b);
    if (!(size > 0.0))
        return 0.0;
    double sine = size / (l_a * l_b);
    if (!(sine < 0.5) || !(cosine > 0.0))
        return (atan2(size, cosine) - size / r / r) * e->gamma_N;
    /* r - |a| = (ref - a).(ref + a)/(r + |a|) */
    double from_a = -v3_dot(e->a_ref, v3_add(ref, e->a)) / (r + l_a);
    double from_b = -v3_dot(e->b_ref, v3_add(ref, e->b)) / (r + l_b);
    double difference = excess_of_arc(sine) + (from_a + l_a * (from_b / r)) / r;
    return difference * sine * e->gamma_N;
}

/* The farthest point of the outline that is above the horizon; false: nothing is. */
static bool find_reference(rl_vec3 *ref, const struct outline *o)
{
    double most = -1.0;
    for (int i = 0; i < o->n; i++) {
        struct part e;
        if (!part_of_edge(&e, o, i, o->P))
            continue;
        double a_a = v3_dot(e.a, e.a), b_b = v3_dot(e.b, e.b);
        if (fmax(a_a, b_b) > most)
            *ref = a_a > b_b ? e.a : e.b;
        most = fmax(most, fmax(a_a, b_b));
    }
    return most > 0.0;
}

/* b - a, from P or from the reference point: what is nearer has lost less of it. */
static rl_vec3 from_to(rl_vec3 a, rl_vec3 b, rl_vec3 a_ref, rl_vec3 b_ref)
{
    double near = v3_dot(a, a) + v3_dot(b, b), near_ref = v3_dot(a_ref, a_ref) + v3_dot(b_ref, b_ref);
    return near < near_ref ? v3_sub(b, a) : v3_sub(b_ref, a_ref);
}

/* The signed sum over edges, twice the irradiance. */
static double edge_sum(const struct outline *o)
{
    rl_vec3 ref, first = {0.0, 0.0, 0.0}, first_ref = first;
    if (!find_reference(&ref, o))
        return 0.0;
    double r = v3_length(ref), sum = 0.0, area = 0.0;
    bool crossed = false;
    rl_vec3 at = v3_madd(o->P, 1.0 / o->up, ref);
    for (int i = 0; i < o->n; i++) {
        struct part e;
        if (!part_of_edge(&e, o, i, at))
            continue;
        area += v3_dot(o->N, v3_cross(e.a_ref, e.along));
        sum += edge_term(&e, ref, r);
        if (!e.up && !e.down)
            continue;
        rl_vec3 crossing = e.up ? e.a : e.b, crossing_ref = e.up ? e.a_ref : e.b_ref;
        if (!crossed) {
            first = crossing;
            first_ref = crossing_ref;
        }
        struct part closing = {.a = first, .b = crossing, .a_ref = first_ref, .b_ref = crossing_ref};
        closing.along = from_to(first, crossing, first_ref, crossing_ref);
        /* Both ends lie on the horizon. */
        closing.gamma_N = copysign(1.0, v3_dot(o->N, v3_cross(first, closing.along)));
        double sign = e.up ? 1.0 : -1.0;
        area += sign * v3_dot(o->N, v3_cross(first_ref, closing.along));
        sum += sign * edge_term(&closing, ref, r);
        crossed = true;
    }
    return area / r / r + sum;
}

static void area(const struct rl_surface *s, const rl_vec3 *vertex, int n, double params[][4], double rgb[3])
{
    const struct outline o = outline_of(s, vertex, n);
    bool in_plane = rl_plane_distance(vertex, (size_t)n, s->P, RL_UNIT_DOUBLE) == 0.0;
    double irradiance = in_plane ? 0.0 : 0.5 * fabs(edge_sum(&o));
    for (int c = 0; c < 3; c++)
        rgb[c] = params[0][c] * irradiance;
}

const struct rl_effect rl_effect_diffuse_area = {
    .name = "diffuse-area",
    .summary = "k_d: Lambert's law, polygon lights by their exact irradiance",
    .sees = RL_SEES_SOURCES | RL_SEES_POLYGONS,
    .roles = RL_ROLE_DIFFUSE,
    .param = rl_lambert_param,
    .modules = {"common/arctangent"},
    .n_params = 1,
    .pack = rl_lambert_pack,
    .reflect = rl_lambert_reflect,
    .area = area,
    .absolute = 1e-6,
};
