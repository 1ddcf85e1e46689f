/* Fur, from its papers: fibres along n, l to the light, e to the eye; psi between n and l, theta between n and -e.
 *
 *     k_d sin(psi) + k_s max(0, cos(psi - theta))^p       Kajiya and Kay 1989
 *     k_d sin(psi) + k_s |cos(psi + theta)|^p             a listing of it, with a wrong sign
 *     k_d sin(psi) + k_s |n x h|^p, h = (l + e)/2         Lengyel 2000
 *     ((1 + kappa)/2 rho_reflect + (1 - kappa)/2 rho_transmit) f_surf times the first or second     Goldman 1997
 *
 * kappa: the cosine of n x l and n x e, each of which counts for 1e-4 at least; c stands for rho = (1 + c)/2 and (1 - c)/2. f_surf is
 * 2 l.n + 1, which Goldman clamps to 0..1 and the listing does not. monochrome: colours as their luminance (ITU-R BT.709).
 */
#include "exact_arithmetic.h"

struct fibre {
    vec n, e, l;
};

static struct fibre fibre_of(mpfr_t in[])
{
    return (struct fibre){unit(vector(in, 0)), unit(vector(in, 3)), unit(vector(in, 6))};
}

static num cone(const struct fibre *f, bool printed)
{
    num sines = times(length(cross(f->n, f->l)), length(cross(f->n, f->e)));
    num cosines = times(dot(f->n, f->l), dot(f->n, f->e));
    return printed ? size_of(plus(sines, cosines)) : most_of(number(0.0), minus(sines, cosines));
}

static num luminance(mpfr_t in[], size_t first)
{
    static const double weight[] = {0.2126, 0.7152, 0.0722};
    num y = number(0.0);
    for (size_t c = 0; c < 3; c++)
        y = plus(y, times(number(weight[c]), in[first + c]));
    return y;
}

static void give_sum(mpfr_t out[], mpfr_t in[], num factor, num sine, num lobe, size_t monochrome)
{
    num highlight = power(lobe, in[15]);
    bool grey = mpfr_cmp_d(in[monochrome], 0.5) > 0;
    for (size_t c = 0; c < 3; c++) {
        num diffuse = grey ? luminance(in, 9) : in[9 + c], specular = grey ? luminance(in, 12) : in[12 + c];
        give(out[c], times(factor, plus(times(diffuse, sine), times(specular, highlight))));
    }
}

static void kajiya(mpfr_t out[], mpfr_t in[], bool printed)
{
    exact_begin();
    struct fibre f = fibre_of(in);
    give_sum(out, in, number(1.0), length(cross(f.n, f.l)), cone(&f, printed), 16);
}

void exact_kajiya(mpfr_t out[], mpfr_t in[])
{
    kajiya(out, in, false);
}

void exact_kajiya_printed(mpfr_t out[], mpfr_t in[])
{
    kajiya(out, in, true);
}

void exact_lengyel(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    struct fibre f = fibre_of(in);
    vec h = scaled(number(0.5), sum(f.l, f.e));
    give_sum(out, in, number(1.0), length(cross(f.n, f.l)), length(cross(f.n, h)), 16);
}

static num kappa_of(const struct fibre *f)
{
    num least = number(1e-4);
    vec a = cross(f->n, f->l), b = cross(f->n, f->e);
    return over(dot(a, b), times(most_of(length(a), least), most_of(length(b), least)));
}

static num direction(const struct fibre *f, mpfr_t in[])
{
    num one = number(1.0), half = number(0.5), kappa = kappa_of(f);
    bool given = mpfr_nan_p(in[16]) == 0;
    num reflect = given ? times(half, plus(one, in[16])) : in[17];
    num transmit = given ? times(half, minus(one, in[16])) : in[18];
    return times(half, plus(times(plus(one, kappa), reflect), times(minus(one, kappa), transmit)));
}

static void goldman(mpfr_t out[], mpfr_t in[], bool printed)
{
    exact_begin();
    struct fibre f = fibre_of(in);
    num one = number(1.0), surface = plus(times(number(2.0), dot(f.n, f.l)), one);
    if (!printed)
        surface = least_of(one, most_of(number(0.0), surface));
    give_sum(out, in, times(direction(&f, in), surface), length(cross(f.n, f.l)), cone(&f, printed), 19);
}

void exact_goldman(mpfr_t out[], mpfr_t in[])
{
    goldman(out, in, false);
}

void exact_goldman_printed(mpfr_t out[], mpfr_t in[])
{
    goldman(out, in, true);
}

/* ---- Terms; arguments are n, l, e ---- */

static struct fibre term_of(mpfr_t in[])
{
    return (struct fibre){.n = unit(vector(in, 0)), .l = unit(vector(in, 3)), .e = unit(vector(in, 6))};
}

void exact_fur_sine(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    give(out[0], length(cross(unit(vector(in, 0)), unit(vector(in, 3)))));
}

static void cone_term(mpfr_t out[], mpfr_t in[], bool printed)
{
    exact_begin();
    struct fibre f = term_of(in);
    give(out[0], power(cone(&f, printed), in[9]));
}

void exact_fur_cone(mpfr_t out[], mpfr_t in[])
{
    cone_term(out, in, false);
}

void exact_fur_cone_printed(mpfr_t out[], mpfr_t in[])
{
    cone_term(out, in, true);
}

void exact_fur_half(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    struct fibre f = term_of(in);
    give(out[0], length(cross(f.n, scaled(number(0.5), sum(f.l, f.e)))));
}

/* Either share is a square of half the chord of two unit vectors: as little as those are known to a unit in the last place, it may be. */
double exact_fur_kappa_whole(mpfr_t in[])
{
    (void)in;
    return 0x1p-53;
}

void exact_fur_kappa(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    struct fibre f = term_of(in);
    num one = number(1.0), half = number(0.5), kappa = kappa_of(&f);
    give(out[0], kappa);
    give(out[1], times(half, plus(one, kappa)));
    give(out[2], times(half, minus(one, kappa)));
}
