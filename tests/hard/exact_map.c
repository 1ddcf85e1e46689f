/* Maps for the catalogue of hard cases: exact answers over grids of two arguments, tests/hard/maps/NAME.tsv.
 *
 *     across ARGUMENT VALUE...       the values of an argument along the axis across; `shown`: what stands at the axis
 *     up ARGUMENT VALUE...           likewise
 *     all ARGUMENT VALUE             the same at every point; one that no line names is left out
 *     ulp RESULT...                  then a line a point, those across first: of each result the exact answer, and both bounds (of
 *                                    double and of single precision, as exact.c has them) over what no argument's rounding widens;
 *                                    of an answer of 0, whose units in the last place are next to nothing, the bounds themselves
 *     absolute RESULT...             in its place where errors count in the last place of 1: answers alone
 *
 * Every argument is a number of single precision, so that one answer serves both. A row of `maps` below is a file.
 */
#include "exact.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ACROSS, UP, AXES };

/* Single precision. */
static double single(double x)
{
    return (double)(float)x;
}

/* ---- R_r, delta, U ---- */

/* Evenly spaced in logarithms where R_r is far from 1, and in those of |R_r - 1| near it. */
static double rr_at(size_t i)
{
    if (i < 10)
        return single(1.0000001e-6 * pow(5e5, (double)i / 9.0)); /* single precision rounds 1e-6 down */
    if (i < 17)
        return single(1.0 - pow(10.0, 9.0 - (double)i));
    if (i == 17)
        return 1.0;
    if (i < 25)
        return single(1.0 + pow(10.0, (double)i - 25.0));
    return single(2.0 * pow(5e11, (double)(i - 25) / 22.0));
}

enum { RR = 48 };

static double delta_at(size_t i)
{
    /* Of both signs; the largest is the last number of single precision below pi/2. */
    static const double size[] = {1e-30, 1e-16, 1e-10, 1e-7,  1e-5,  1e-4,   1e-3,    0.01,
                                  0.1,   0.5,   1.0,   1.471, 1.561, 1.5698, 1.57079, 1.57079625};
    enum { N = sizeof size / sizeof size[0] };
    return i < N ? -single(size[N - 1 - i]) : single(size[i - N]);
}

enum { UNITS = 26 };

static double u_at(size_t i)
{
    static const double u[UNITS] = {0.0,  1e-37, 1e-20, 1e-9,  1e-7,       1e-5,    1e-4,       1e-3,  0.01,
                                    0.1,  0.25,  0.49,  0.499, 0.49999997, 0.5,     0.50000006, 0.501, 0.51,
                                    0.75, 0.9,   0.99,  0.999, 0.9999,     0.99999, 0.99999994, 1.0};
    return single(u[i]);
}

static void row_of_delta(double row[], const size_t at[AXES])
{
    row[0] = rr_at(at[ACROSS]);
    row[1] = delta_at(at[UP]);
}

static void row_of_u(double row[], const size_t at[AXES])
{
    row[0] = rr_at(at[ACROSS]);
    row[1] = u_at(at[UP]);
}

/* ---- N.V, N.L ---- */

/* n cosines: half of them grazing, evenly spaced in logarithms from `least` to 0.01, half evenly from there to 1. */
static double cosine_at(size_t i, size_t n, double least)
{
    size_t half = n / 2;
    double t = (double)(i % half) / (double)(half - (i >= half));
    return i < half ? least * pow(0.01 / least, t) : 0.01 + 0.99 * t;
}

enum { COSINES_ACROSS = 48, COSINES_UP = 32 };

static double cosine_of(int axis, size_t i)
{
    return cosine_at(i, axis == ACROSS ? COSINES_ACROSS : COSINES_UP, 1e-30);
}

static void row_of_attenuation(double row[], const size_t at[AXES])
{
    row[0] = single(0.7); /* not short: products are to be rounded */
    row[1] = single(cosine_of(ACROSS, at[ACROSS]));
    row[2] = single(cosine_of(UP, at[UP]));
    row[3] = single(0.6);
}

/* The height above the unit circle at which a direction has that cosine. */
static double height_of(double cosine)
{
    return cosine < 1.0 ? single(cosine / sqrt((1.0 - cosine) * (1.0 + cosine))) : 1e8;
}

/* ---- N over the sphere ---- */

/* Longitudes in radians from 0, where they are fine, to below a right angle; mirrored they make the whole turn. */
static const double longitudes[] = {0.0, 1e-7, 1e-4, 0.01, 0.1, 0.3, 0.6, 0.9, 1.2};
/* Tangents of latitudes, from the equator up. */
static const double tangents[] = {1e-30, 1e-3, 0.57735, 1.73205, 10.0, 100.0, 1e4, 1e8, 1e30};

enum {
    LONGITUDES = sizeof longitudes / sizeof longitudes[0], /* in a quarter of a turn */
    TURN = 4 * LONGITUDES,
    TANGENTS = sizeof tangents / sizeof tangents[0],
    LATITUDES = 2 * TANGENTS
};

/* The i-th of TURN: from just above -180 degrees to 180. */
static void longitude_at(double to[2], size_t i)
{
    int turn = (int)i - (2 * LONGITUDES - 1), k = abs(turn), half = LONGITUDES;
    double angle = longitudes[k < half ? k : k > half ? 2 * half - k : 0];
    to[0] = k == half ? 0.0 : single(k < half ? cos(angle) : -cos(angle));
    to[1] = k == half ? 1.0 : single(sin(angle));
    to[1] = turn < 0 ? -to[1] : to[1];
}

static double tangent_at(size_t i)
{
    return single(i < TANGENTS ? -tangents[TANGENTS - 1 - i] : tangents[i - TANGENTS]);
}

static void row_of_normal(double row[], const size_t at[AXES])
{
    longitude_at(row, at[ACROSS]);
    row[2] = tangent_at(at[UP]);
}

static double degrees_of(int axis, size_t i)
{
    double n[2];
    longitude_at(n, i);
    double angle = axis == ACROSS ? atan2(n[1], n[0]) : atan(tangent_at(i));
    return round(1e7 * angle * 180.0 / 3.14159265358979323846) / 1e7;
}

/* Glass of index 1.5, roughness 1/4, Beckmann's distribution; V and L on the unit circle about N, at their heights above it. */
static void row_of_facets(double row[], const size_t at[AXES])
{
    static const double fixed[] = {[2] = 1.0,  [3] = 1.0,  [6] = -0.6,  [7] = 0.8, [12] = 1.5,
                                   [13] = 1.5, [14] = 1.5, [18] = 0.25, [19] = 0.0};
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0]; i++)
        if (i < 9 || i > 11) /* 9 to 11 would be a reflectance in place of the index */
            row[i] = single(fixed[i]);
    row[5] = height_of(cosine_of(ACROSS, at[ACROSS]));
    row[8] = height_of(cosine_of(UP, at[UP]));
}

/* ---- Files ---- */

struct map {
    const char *name, *comment;
    size_t n[AXES];
    const char *axis; /* of each argument: a, across; u, up; -, the same everywhere */
    const char *in[EXACT_IN_MAX];
    void (*row)(double row[], const size_t at[AXES]); /* what it leaves alone is left out */
    double (*shown)(int axis, size_t i);              /* NULL: the first argument of the axis */
    bool judged[EXACT_OUT_MAX];
    bool absolute;
};

#define OF_NORMAL                                                                                            \
    .n = {TURN, LATITUDES}, .axis = "aau", .in = {"nx", "ny", "nz"}, .row = row_of_normal,                   \
    .shown = degrees_of, .judged = {true, true, true, true, true, true}, .absolute = true

static const struct map maps[] = {
    {.name = "ellipsoid-pdf",
     .comment = "D(delta) over R_r and delta: both are spaced by how near they are to 1, 0 and +-pi/2",
     .n = {RR, 32},
     .axis = "au",
     .in = {"rr", "delta"},
     .row = row_of_delta,
     .judged = {true}},
    {.name = "ellipsoid-cdf",
     .comment = "U(delta) over R_r and delta: both are spaced by how near they are to 1, 0 and +-pi/2",
     .n = {RR, 32},
     .axis = "au",
     .in = {"rr", "delta"},
     .row = row_of_delta,
     .judged = {true}},
    {.name = "ellipsoid-inverse",
     .comment = "delta(U) and its cosine over R_r and U, which is spaced by how near it is to 0, 1/2 and 1",
     .n = {RR, UNITS},
     .axis = "au",
     .in = {"rr", "u"},
     .row = row_of_u,
     .judged = {true, false, true}},
    {.name = "attenuation",
     .comment = "G over N.V and N.L, half of them grazing, where N.H = 0.7 and V.H = 0.6",
     .n = {COSINES_ACROSS, COSINES_UP},
     .axis = "-au-",
     .in = {"n_h", "n_v", "n_l", "v_h"},
     .row = row_of_attenuation,
     .judged = {true}},
    {.name = "cook-torrance",
     .comment = "F D G/(4 N.V) over N.V and N.L, half of them grazing: index 1.5, roughness 1/4, Beckmann's "
                "distribution, azimuths 127 degrees apart",
     .n = {COSINES_ACROSS, COSINES_UP},
     .axis = "-----a--u-----------",
     .in = {"nx",
            "ny",
            "nz",
            "vx",
            "vy",
            "vz",
            "lx",
            "ly",
            "lz",
            "reflectance_r",
            "reflectance_g",
            "reflectance_b",
            "n_r",
            "n_g",
            "n_b",
            "k_r",
            "k_g",
            "k_b",
            "roughness",
            "distribution"},
     .row = row_of_facets,
     .shown = cosine_of,
     .judged = {true}},
    {.name = "frame", .comment = "T and B over the sphere of N, fine at the poles and at +-x", OF_NORMAL},
    {.name = "frame-printed",
     .comment = "T and B as printed over the sphere of N, fine at the poles and at +-x, where they vanish",
     OF_NORMAL},
};

static const struct exact_function *function_of(const struct map *m)
{
    for (size_t i = 0; i < exact_n_functions; i++)
        if (strcmp(exact_functions[i].name, m->name) == 0)
            return &exact_functions[i];
    fprintf(stderr, "%s: found a map of it, expected a function of exact_table.c\n", m->name);
    exit(2);
}

/* The arguments of a point; NaN: left out. */
static void make_row(double row[], const struct map *m, size_t n_in, size_t across, size_t up)
{
    for (size_t i = 0; i < n_in; i++)
        row[i] = NAN;
    m->row(row, (const size_t[]){across, up});
}

static void write_axes(FILE *to, const struct map *m, size_t n_in)
{
    double row[EXACT_IN_MAX];
    for (size_t i = 0; i < n_in; i++) {
        bool across = m->axis[i] == 'a', up = m->axis[i] == 'u';
        size_t n = across ? m->n[ACROSS] : up ? m->n[UP] : 1;
        make_row(row, m, n_in, 0, 0);
        if (isnan(row[i]))
            continue;
        fprintf(to, "%s\t%s", across ? "across" : up ? "up" : "all", m->in[i]);
        for (size_t k = 0; k < n; k++) {
            make_row(row, m, n_in, across ? k : 0, up ? k : 0);
            fprintf(to, "\t%.17g", row[i]);
        }
        fputc('\n', to);
    }
    for (int axis = 0; axis < AXES && m->shown; axis++) {
        fprintf(to, "%s\tshown", axis == ACROSS ? "across" : "up");
        for (size_t k = 0; k < m->n[axis]; k++)
            fprintf(to, "\t%.9g", m->shown(axis, k));
        fputc('\n', to);
    }
}

static void stop(const struct map *m, size_t point, const char *found, const char *expected)
{
    fprintf(stderr, "%s: point %zu: found %s, expected %s\n", m->name, point, found, expected);
    exit(2);
}

/* What a bound is that no argument's rounding widens. */
static double plain_bound(mpfr_t y, int precision)
{
    double value = fabs(mpfr_get_d(y, MPFR_RNDN));
    if (precision == 1)
        return fmax(1e-5 * value, 1e-6);
    return 8.0 *
           (value > 0.0 ? fmax(ldexp(1.0, ilogb(value) - DBL_MANT_DIG + 1), DBL_TRUE_MIN) : DBL_TRUE_MIN);
}

/* 19 digits, and in absolute terms 17 behind the point: errors to within a fiftieth of a unit in the last place of 1. */
static void write_answer(FILE *to, const struct map *m, struct exact_answer *a, size_t k)
{
    bool zero =
        mpfr_get_d(a->out[0][k], MPFR_RNDN) == 0.0; /* or next to it: the cosine of asin(1), rounded */
    if (zero)
        fputc('0', to);
    else
        mpfr_fprintf(to, m->absolute ? "%.17Rf" : "%.18Re", a->out[0][k]);
    for (int p = 0; p < 2 && !m->absolute; p++)
        fprintf(to, "\t%.3g",
                zero ? a->bound[p][k] : fmax(a->bound[p][k] / plain_bound(a->out[0][k], p), 1.0));
}

static void write_points(FILE *to, const struct map *m, const struct exact_function *f)
{
    double row[EXACT_IN_MAX];
    struct exact_answer a;
    exact_answer_init(&a, f);
    for (size_t i = 0; i < m->n[ACROSS] * m->n[UP]; i++) {
        bool first = true;
        make_row(row, m, f->n_in, i % m->n[ACROSS], i / m->n[ACROSS]);
        if (!exact_answer_make(&a, f, row))
            stop(m, i, "an answer that is not finite", "arguments within the function's range");
        for (size_t k = 0; k < f->n_out; k++) {
            if (!m->judged[k])
                continue;
            if (mpfr_cmp(a.out[0][k], a.out[1][k]) != 0)
                stop(m, i, "arguments that single precision rounds", "numbers of single precision");
            if (!first)
                fputc('\t', to);
            first = false;
            write_answer(to, m, &a, k);
        }
        fputc('\n', to);
    }
    exact_answer_clear(&a, f);
}

const char *exact_map_name(size_t i)
{
    return i < sizeof maps / sizeof maps[0] ? maps[i].name : NULL;
}

void exact_map_write(FILE *to, size_t i)
{
    const struct map *m = &maps[i];
    const struct exact_function *f = function_of(m);
    fprintf(to, "# %s.\n", m->comment);
    write_axes(to, m, f->n_in);
    fputs(m->absolute ? "absolute" : "ulp", to);
    for (size_t k = 0; k < f->n_out; k++)
        if (m->judged[k])
            fprintf(to, "\t%s", f->out[k]);
    fputc('\n', to);
    write_points(to, m, f);
}
