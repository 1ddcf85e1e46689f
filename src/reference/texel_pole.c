/* Integrals of the weight over texels near its poles (see texel_pole.h). */
#include "reference/texel_pole.h"

#include <float.h>
#include <math.h>

/* How large a square may be. Where it lies this many of its edges away, w itself is smooth, and four Gauss points integrate it to 1e-3
 * of its share; nearer, F must be smooth, which it is over this part of the distance in which it varies. */
#define AWAY_EDGES 2.0
#define FINE 0.25

/* Divisions at most: at the mirror direction as many as R_r = 1e12 needs; at L = -V, where no square is fine, until what is left weighs
 * 2^-8 of the texel; on the horizon, where the image folds over and squares along a whole line are divided, as many as it takes for the
 * weight of a grazing eye, which is as high above the horizon as V, to be seen: RL_TEXEL_GRAZING tells from where on it is not. */
enum { DEEPEST = 40, DEEPEST_BEHIND = 8, DEEPEST_FOLDED = 12 };

struct rl_texel_pole rl_texel_pole_make(const struct rl_surface *surface, const struct rl_ellipsoid *e,
                                        bool attenuation, double reach)
{
    struct rl_texel_pole pole = {
        .frame = rl_frame_make(RL_FRAME_ORTHONORMAL, surface->N),
        .rr = e->rr,
        .scale = e->norm / (2.0 * RL_PI * e->rr),
        .reach = reach,
        .attenuation = attenuation,
    };
    pole.v = rl_frame_components(&pole.frame, surface->V);
    return pole;
}

/* A direction of a face, not normalised, and M = V + L in the frame, times the same length. w is homogeneous in M, of degree -1. */
struct half_vector {
    double length, x, y, n;
};

static struct half_vector towards(const struct rl_texel_pole *pole, int face, double s, double t)
{
    rl_vec3 L = rl_cube_direction(face, s, t);
    double length = sqrt(1.0 + s * s + t * t);
    return (struct half_vector){.length = length,
                                .x = v3_dot(L, pole->frame.T) + pole->v.x * length,
                                .y = v3_dot(L, pole->frame.B) + pole->v.y * length,
                                .n = v3_dot(L, pole->frame.N) + pole->v.z * length};
}

/* F, with u = |y|^2; of degree 0. */
static double smooth_factor(const struct rl_texel_pole *pole, const struct half_vector *m, double u)
{
    double n = m->n, n_v = pole->v.z * m->length, q = u + n * n, share = q;
    if (pole->attenuation)
        share = fmin(q, 4.0 * n * fmax(0.0, fmin(n_v, n - n_v)));
    double below = (n * n / pole->rr + pole->rr * u) * sqrt(q);
    return below > 0.0 ? pole->scale * fabs(n) * share / below : 0.0;
}

double rl_texel_weight(const struct rl_texel_pole *pole, int face, double s, double t)
{
    struct half_vector m = towards(pole, face, s, t);
    double least = fmax(DBL_MIN, pole->reach * m.length);
    double u = fmax(m.x * m.x + m.y * m.y, least * least);
    return smooth_factor(pole, &m, u) / sqrt(u) * m.length;
}

double rl_texel_distance(const struct rl_texel_pole *pole, int face, double s, double t)
{
    struct half_vector m = towards(pole, face, s, t);
    return sqrt(m.x * m.x + m.y * m.y) / m.length;
}

double rl_texel_solid_angle(double s, double t, double half)
{
    double rr = 1.0 / (1.0 + s * s + t * t);
    return 4.0 * half * half * rr * sqrt(rr) * (1.0 + half * half * rr * (1.5 - 2.5 * rr));
}

/* A point in the plane of y. */
struct point {
    double x, y;
};

/* The integral of 1/|y| over the triangle (0, a, b), signed; *area grows by the triangle's. */
static double edge_share(double *area, struct point a, struct point b)
{
    double x = b.x - a.x, y = b.y - a.y, length = sqrt(x * x + y * y), cross = a.x * b.y - a.y * b.x;
    *area += 0.5 * cross;
    /* d log(1/d) vanishes with d; here it is below all rounding, and d^2 is not yet 0. */
    if (!(fabs(cross) > 1e-60 * length))
        return 0.0;
    double from = (a.x * x + a.y * y) / length, to = (b.x * x + b.y * y) / length, d = cross / length;
    double la = sqrt(a.x * a.x + a.y * a.y), lb = sqrt(b.x * b.x + b.y * b.y);
    /* asinh(e/d) = log((e + |y|)/d), and e + |y| = d^2/(|y| - e) where e < 0. */
    double above = to >= 0.0 ? to + lb : d * d / (lb - to);
    double below = from >= 0.0 ? from + la : d * d / (la - from);
    return d * log(above / below);
}

struct square {
    int face;
    double s, t, half;
};

/* The square's corners in the plane of y; whether some lie above the horizon and some below. */
static bool find_corners(struct point corner[4], const struct rl_texel_pole *pole, const struct square *q)
{
    static const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    int above = 0;
    for (int i = 0; i < 4; i++) {
        struct half_vector m = towards(pole, q->face, q->s + at[i][0] * q->half, q->t + at[i][1] * q->half);
        corner[i] = (struct point){m.x / m.length, m.y / m.length};
        above += m.n > pole->v.z * m.length;
    }
    return above != 0 && above != 4;
}

/* The mean of 1/|y| over a polygon of four corners; 0 where it is so flat that its area is rounding, as near a fold. */
static double mean_inverse(const struct point corner[4])
{
    double area = 0.0, sum = 0.0, size = 0.0;
    for (int i = 0; i < 4; i++) {
        struct point a = corner[i], b = corner[(i + 1) % 4];
        sum += edge_share(&area, a, b);
        size = fmax(size, fmax(a.x * a.x + a.y * a.y, fabs(a.x * b.y) + fabs(a.y * b.x)));
    }
    return fabs(area) > 1e-12 * size ? sum / area : 0.0;
}

/* Gauss and Legendre's two points along either axis. */
static double by_gauss(const struct rl_texel_pole *pole, const struct square *q)
{
    const double at = 0.57735026918962576451 * q->half;
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        struct half_vector m = towards(pole, q->face, q->s + (i & 1 ? at : -at), q->t + (i & 2 ? at : -at));
        double u = fmax(DBL_MIN, m.x * m.x + m.y * m.y);
        /* Times length, as w is, and over its cube, the solid angle of a square of the face. */
        sum += smooth_factor(pole, &m, u) / (sqrt(u) * m.length * m.length);
    }
    return sum * q->half * q->half;
}

static struct square quarter(const struct square *q, int i)
{
    double half = 0.5 * q->half;
    return (struct square){q->face, q->s + (i & 1 ? half : -half), q->t + (i & 2 ? half : -half), half};
}

/* F at the centre times the closed form; at a fold, times 1/|y| held finite. */
static double by_centre(const struct rl_texel_pole *pole, const struct square *q)
{
    struct half_vector m = towards(pole, q->face, q->s, q->t);
    struct point corner[4];
    double u = m.x * m.x + m.y * m.y, edge = 2.0 * q->half / m.length;
    bool folded = find_corners(corner, pole, q);
    double inverse = folded ? 0.0 : mean_inverse(corner);
    if (!(inverse > 0.0))
        inverse = 1.0 / fmax(sqrt(u) / m.length, 0.25 * edge);
    return smooth_factor(pole, &m, u) * inverse * rl_texel_solid_angle(q->s, q->t, q->half);
}

static double square_integral(const struct rl_texel_pole *pole, const struct square *q, int depth,
                              size_t *evaluations)
{
    struct half_vector m = towards(pole, q->face, q->s, q->t);
    double y = sqrt(m.x * m.x + m.y * m.y), edge = 2.0 * q->half, sum = 0.0;
    if (y >= AWAY_EDGES * edge) {
        *evaluations += 4;
        return by_gauss(pole, q);
    }
    struct point corner[4];
    bool folded = find_corners(corner, pole, q);
    double varies_over = fmin(fmax(y, fabs(m.n) / pole->rr), sqrt(y * y + m.n * m.n));
    bool fine = !folded && FINE * varies_over >= edge;
    int deepest = folded ? DEEPEST_FOLDED : m.n < pole->v.z * m.length ? DEEPEST_BEHIND : DEEPEST;
    bool divide = !fine && depth < deepest;
    for (int i = 0; i < 4; i++) {
        struct square part = quarter(q, i);
        sum += divide ? square_integral(pole, &part, depth + 1, evaluations) : by_centre(pole, &part);
    }
    if (divide)
        return sum;
    /* The error of either is as the square of its edge: Richardson. */
    *evaluations += 5;
    return fine ? (4.0 * sum - by_centre(pole, q)) / 3.0 : sum;
}

double rl_texel_integral(const struct rl_texel_pole *pole, int face, double s, double t, double half,
                         size_t *evaluations)
{
    struct square whole = {face, s, t, half};
    return square_integral(pole, &whole, 0, evaluations);
}
