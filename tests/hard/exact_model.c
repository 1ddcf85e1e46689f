/* Frames, attenuation, distributions over solid angle, angles and indices, each by its definition. */
#include "exact.h"

/* ---- Frames: N made unit; components may be 300 decades apart, and their squares 600 ---- */

enum { FRAME_BITS = 4600 };

static void unit(mpfr_t n[3], mpfr_t in[])
{
    mpfr_t sum, square;
    mpfr_inits2(FRAME_BITS, sum, square, (mpfr_ptr)0);
    mpfr_set_zero(sum, 1);
    for (int c = 0; c < 3; c++) {
        mpfr_sqr(square, in[c], MPFR_RNDN);
        mpfr_add(sum, sum, square, MPFR_RNDN);
    }
    mpfr_sqrt(sum, sum, MPFR_RNDN);
    for (int c = 0; c < 3; c++) {
        mpfr_init2(n[c], FRAME_BITS);
        mpfr_div(n[c], in[c], sum, MPFR_RNDN);
    }
    mpfr_clears(sum, square, (mpfr_ptr)0);
}

/* Duff et al. 2017, listing 3: a = -1/(sign + z), b = x y a, T = (1 + sign x x a, sign b, -sign x), B = (b, sign + y y a, -y); the sign is
 * that of z, of zero too. */
void exact_frame(mpfr_t out[], mpfr_t in[])
{
    mpfr_t n[3], a, w;
    unit(n, in);
    long sign = mpfr_signbit(n[2]) ? -1 : 1;
    mpfr_inits2(FRAME_BITS, a, w, (mpfr_ptr)0);
    mpfr_add_si(a, n[2], sign, MPFR_RNDN);
    mpfr_si_div(a, -1, a, MPFR_RNDN);
    for (size_t k = 0; k < 2; k++) {
        mpfr_sqr(w, n[k], MPFR_RNDN);
        mpfr_mul(w, w, a, MPFR_RNDN);
        mpfr_mul_si(w, w, k == 0 ? sign : 1, MPFR_RNDN);
        mpfr_add_si(out[4 * k], w, k == 0 ? 1 : sign, MPFR_RNDN);
    }
    mpfr_mul(w, n[0], n[1], MPFR_RNDN);
    mpfr_mul(w, w, a, MPFR_RNDN);
    mpfr_mul_si(out[1], w, sign, MPFR_RNDN);
    mpfr_set(out[3], w, MPFR_RNDN);
    mpfr_mul_si(out[2], n[0], -sign, MPFR_RNDN);
    mpfr_neg(out[5], n[1], MPFR_RNDN);
    mpfr_clears(n[0], n[1], n[2], a, w, (mpfr_ptr)0);
}

/* As Kimura and Tokoi print it: rows (0, z, -y) and (y y + z z, -x y, -x z). */
void exact_frame_printed(mpfr_t out[], mpfr_t in[])
{
    mpfr_t n[3], w;
    unit(n, in);
    mpfr_init2(w, FRAME_BITS);
    mpfr_set_zero(out[0], 1);
    mpfr_set(out[1], n[2], MPFR_RNDN);
    mpfr_neg(out[2], n[1], MPFR_RNDN);
    mpfr_fmma(w, n[1], n[1], n[2], n[2], MPFR_RNDN);
    mpfr_set(out[3], w, MPFR_RNDN);
    for (int c = 1; c < 3; c++) {
        mpfr_mul(w, n[0], n[c], MPFR_RNDN);
        mpfr_neg(out[3 + c], w, MPFR_RNDN);
    }
    mpfr_clears(n[0], n[1], n[2], w, (mpfr_ptr)0);
}

/* ---- Attenuation ---- */

/* max(0, min(1, 2 (N.H)(N.V)/(V.H), 2 (N.H)(N.L)/(V.H))), and 0 unless all four cosines n_h, n_v, n_l, v_h are above 0: a facet that faces
 * away from the surface, and one that the eye or the light does not see. */
void exact_attenuation(mpfr_t out[], mpfr_t in[])
{
    mpfr_set_zero(out[0], 1);
    for (int i = 0; i < 4; i++)
        if (mpfr_sgn(in[i]) <= 0)
            return;
    mpfr_min(out[0], in[1], in[2], MPFR_RNDN);
    mpfr_mul(out[0], out[0], in[0], MPFR_RNDN);
    mpfr_mul_ui(out[0], out[0], 2, MPFR_RNDN);
    mpfr_div(out[0], out[0], in[3], MPFR_RNDN);
    if (mpfr_cmp_ui(out[0], 1) > 0)
        mpfr_set_ui(out[0], 1, MPFR_RNDN);
}

/* ---- Distributions of facets over solid angle, of m and delta ---- */

/* exp(-tan^2/m^2) / (pi m^2 cos^4), which is even in cos: 0 beyond pi/2, as at it. */
void exact_facets_beckmann(mpfr_t out[], mpfr_t in[])
{
    mpfr_t tangent, cosine, pi;
    mpfr_inits(tangent, cosine, pi, (mpfr_ptr)0);
    mpfr_tan(tangent, in[1], MPFR_RNDN);
    mpfr_div(tangent, tangent, in[0], MPFR_RNDN);
    mpfr_sqr(tangent, tangent, MPFR_RNDN);
    mpfr_neg(tangent, tangent, MPFR_RNDN);
    mpfr_exp(out[0], tangent, MPFR_RNDN);
    mpfr_cos(cosine, in[1], MPFR_RNDN);
    mpfr_sqr(cosine, cosine, MPFR_RNDN);
    mpfr_mul(cosine, cosine, in[0], MPFR_RNDN);
    mpfr_sqr(cosine, cosine, MPFR_RNDN);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul(cosine, cosine, pi, MPFR_RNDN);
    mpfr_div(out[0], out[0], cosine, MPFR_RNDN);
    mpfr_clears(tangent, cosine, pi, (mpfr_ptr)0);
}

/* R^2/(pi (cos^2 + R^2 sin^2)^2) with R = 1/m. */
void exact_facets_ellipsoid(mpfr_t out[], mpfr_t in[])
{
    mpfr_t sine, cosine, rr, pi;
    mpfr_inits(sine, cosine, rr, pi, (mpfr_ptr)0);
    mpfr_sin_cos(sine, cosine, in[1], MPFR_RNDN);
    mpfr_ui_div(rr, 1, in[0], MPFR_RNDN);
    mpfr_mul(sine, sine, rr, MPFR_RNDN);
    mpfr_fmma(cosine, cosine, cosine, sine, sine, MPFR_RNDN);
    mpfr_div(out[0], rr, cosine, MPFR_RNDN);
    mpfr_sqr(out[0], out[0], MPFR_RNDN);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_div(out[0], out[0], pi, MPFR_RNDN);
    mpfr_clears(sine, cosine, rr, pi, (mpfr_ptr)0);
}

/* ---- Others ---- */

/* Of (x, y), y >= 0; 0 for (0, 0). */
void exact_angle(mpfr_t out[], mpfr_t in[])
{
    if (mpfr_zero_p(in[0]) && mpfr_zero_p(in[1]))
        mpfr_set_zero(out[0], 1);
    else
        mpfr_atan2(out[0], in[0], in[1], MPFR_RNDN);
}

void exact_direction(mpfr_t out[], mpfr_t in[])
{
    mpfr_t n[3];
    unit(n, in);
    for (int c = 0; c < 3; c++) {
        mpfr_set(out[c], n[c], MPFR_RNDN);
        mpfr_clear(n[c]);
    }
}

/* 2 (N.V) N - V of unit vectors. */
void exact_mirror(mpfr_t out[], mpfr_t in[])
{
    mpfr_t n[3], v[3], twice, w;
    unit(n, in);
    unit(v, in + 3);
    mpfr_inits2(FRAME_BITS, twice, w, (mpfr_ptr)0);
    mpfr_fmma(twice, n[0], v[0], n[1], v[1], MPFR_RNDN);
    mpfr_fma(twice, n[2], v[2], twice, MPFR_RNDN);
    mpfr_mul_2ui(twice, twice, 1, MPFR_RNDN);
    for (int c = 0; c < 3; c++) {
        mpfr_fms(w, twice, n[c], v[c], MPFR_RNDN);
        mpfr_set(out[c], w, MPFR_RNDN);
        mpfr_clears(n[c], v[c], (mpfr_ptr)0);
    }
    mpfr_clears(twice, w, (mpfr_ptr)0);
}

/* Y of ITU-R BT.709-6, item 3.2. */
void exact_luminance(mpfr_t out[], mpfr_t in[])
{
    static const unsigned long weight[] = {2126, 7152, 722};
    mpfr_t part;
    mpfr_init2(part, FRAME_BITS);
    mpfr_set_zero(out[0], 1);
    for (size_t c = 0; c < 3; c++) {
        mpfr_mul_ui(part, in[c], weight[c], MPFR_RNDN);
        mpfr_div_ui(part, part, 10000, MPFR_RNDN);
        mpfr_add(out[0], out[0], part, MPFR_RNDN);
    }
    mpfr_clear(part);
}

/* (1 + sqrt f)/(1 - sqrt f), at most 1e8. */
void exact_reflectance_index(mpfr_t out[], mpfr_t in[])
{
    mpfr_t root, below;
    mpfr_inits(root, below, (mpfr_ptr)0);
    mpfr_sqrt(root, in[0], MPFR_RNDN);
    mpfr_ui_sub(below, 1, root, MPFR_RNDN);
    mpfr_add_ui(root, root, 1, MPFR_RNDN);
    mpfr_set_ui(out[0], 100000000, MPFR_RNDN);
    if (mpfr_sgn(below) > 0) {
        mpfr_div(root, root, below, MPFR_RNDN);
        mpfr_min(out[0], out[0], root, MPFR_RNDN);
    }
    mpfr_clears(root, below, (mpfr_ptr)0);
}
