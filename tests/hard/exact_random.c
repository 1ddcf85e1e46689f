/* See exact_random.h. A row begins as one of the catalogue. Then each direction is drawn anew, or is put in relation to those before it
 * (along, against, across, mirrored), or stays, and is moved by a part of its length of any exponent; and each other argument stays, comes
 * from another row, or from anywhere between the column's ends by value or by exponent, and is moved alike. So rows lie near hard cases,
 * between them, and far from them all. Positions stay together, for sizes of 1e9 beside 1 make needles of every triangle: each is moved by a part of
 * their size, or all are drawn anew of that size. */
#include "exact_random.h"

#include <math.h>
#include <string.h>

/* Steele, Lea and Flood (2014), SplitMix64. */
static uint64_t bits(struct exact_draw *d)
{
    uint64_t z = d->seed + ++d->index * UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

/* In (0, 1). */
static double uniform(struct exact_draw *d)
{
    return ((double)(bits(d) >> 12) + 0.5) * 0x1p-52;
}

static size_t below(struct exact_draw *d, size_t n)
{
    return (size_t)(uniform(d) * (double)n);
}

/* From 1e-16 to 1, as likely of one size as of another. */
static double part(struct exact_draw *d)
{
    return pow(10.0, -16.0 * uniform(d));
}

/* ---- Directions ---- */

static void cross(double to[3], const double a[3], const double b[3])
{
    for (size_t c = 0; c < 3; c++)
        to[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Scaled to about 1; false where it is the zero vector. */
static bool to_size_of_1(double v[3])
{
    double size = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    if (!(size > 0.0) || !isfinite(size))
        return false;
    for (size_t c = 0; c < 3; c++)
        v[c] = ldexp(v[c], -ilogb(size));
    return true;
}

static void move(double v[3], struct exact_draw *d)
{
    double size = part(d);
    for (size_t c = 0; c < 3; c++)
        v[c] += size * (2.0 * uniform(d) - 1.0);
}

/* In relation to direction `of`, or the mirror image of one at another. */
static void relate(double v[3], struct exact_draw *d, const double *of, const double *other)
{
    double any[3] = {uniform(d), uniform(d), -uniform(d)};
    size_t kind = below(d, 4);
    memcpy(v, of, 3 * sizeof *v);
    for (size_t c = 0; c < 3 && kind == 1; c++)
        v[c] = -of[c];
    if (kind == 2)
        cross(v, of, any);
    for (size_t c = 0; c < 3 && kind == 3; c++)
        v[c] = 2.0 * dot(of, other) / dot(of, of) * of[c] - other[c];
}

static void draw_direction(double row[], struct exact_draw *d, size_t which)
{
    double *v = row + 3 * which;
    size_t kind = below(d, which > 0 ? 8 : 4);
    double before[2][3] = {{0.0}};
    for (size_t i = 0; i < 2 && which > 0; i++) {
        memcpy(before[i], row + 3 * (i * (which - 1)), sizeof before[i]);
        to_size_of_1(before[i]);
    }
    if (kind == 0)
        return;
    for (size_t c = 0; c < 3 && kind < 3; c++)
        v[c] = 2.0 * uniform(d) - 1.0;
    for (size_t c = 0; c < 3 && kind == 3; c++)
        v[c] = copysign(part(d), uniform(d) - 0.5);
    if (kind > 4)
        relate(v, d, before[kind % 2], before[1 - kind % 2]);
    if (kind > 3) {
        to_size_of_1(v);
        move(v, d);
    }
    if (!to_size_of_1(v))
        v[below(d, 3)] = 1.0;
}

/* ---- Positions ---- */

static void draw_points(double v[], struct exact_draw *d, size_t n)
{
    double size = 0.0;
    bool anew = below(d, 3) == 0;
    for (size_t i = 0; i < 3 * n; i++)
        size = fmax(size, fabs(v[i]));
    for (size_t i = 0; i < n; i++) {
        double by = below(d, 2) == 0 ? size * part(d) : 0.0;
        for (size_t c = 0; c < 3; c++) {
            double x = 2.0 * uniform(d) - 1.0;
            v[3 * i + c] = anew ? size * x : v[3 * i + c] + by * x;
        }
    }
}

/* ---- Other arguments ---- */

struct column {
    double low, high, least; /* least: the smallest size that is not 0 */
    bool choice;             /* a number of a list, which is not moved */
};

static struct column column_of(const double *rows, size_t n, size_t n_in, size_t i)
{
    struct column c = {INFINITY, -INFINITY, INFINITY, true};
    for (size_t r = 0; r < n; r++) {
        double x = rows[r * n_in + i];
        if (isnan(x))
            continue;
        c.low = fmin(c.low, x);
        c.high = fmax(c.high, x);
        if (x != 0.0)
            c.least = fmin(c.least, fabs(x));
        c.choice = c.choice && (x == 0.0 || x == 1.0);
    }
    return c;
}

static double draw_between(struct exact_draw *d, const struct column *c)
{
    double most = fmax(fabs(c->low), fabs(c->high)), x = c->low + (c->high - c->low) * uniform(d);
    if (below(d, 2) == 0 && c->least < most) {
        x = c->least * pow(most / c->least, uniform(d));
        x = c->low < 0.0 && below(d, 2) == 0 ? -x : x;
    }
    return x;
}

static double draw_argument(double x, struct exact_draw *d, const double *rows, size_t n, size_t n_in,
                            size_t i)
{
    struct column c = column_of(rows, n, n_in, i);
    size_t kind = below(d, 4);
    double other = rows[below(d, n) * n_in + i];
    if (kind > 0 && !isnan(other))
        x = other;
    if (c.choice)
        return x;
    if (kind == 3)
        x = draw_between(d, &c);
    if (below(d, 4) > 0)
        x *= 1.0 + part(d) * (2.0 * uniform(d) - 1.0);
    return fmin(fmax(x, c.low), c.high);
}

void exact_random_row(double row[], struct exact_draw *d, const struct exact_function *f, const double *rows,
                      size_t n)
{
    memcpy(row, rows + below(d, n) * f->n_in, f->n_in * sizeof *row);
    for (size_t i = 0; i < f->n_directions; i++)
        draw_direction(row, d, i);
    draw_points(row + 3 * f->n_directions, d, f->n_points);
    for (size_t i = 3 * (f->n_directions + f->n_points); i < f->n_in; i++)
        if (!isnan(row[i]))
            row[i] = draw_argument(row[i], d, rows, n, f->n_in, i);
    for (size_t i = 0; i < f->n_in && f->whole_numbers; i++)
        row[i] = floor(row[i]);
}
