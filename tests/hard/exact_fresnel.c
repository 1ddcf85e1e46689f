/* Fresnel's formulas for a medium of complex index m = n - i k seen from air (Born and Wolf, Principles of Optics, 7th ed., section 1.5.2,
 * equations 20 and 21, with complex angles as in section 14.2): with q = m cos(theta_t) = sqrt(m^2 - sin^2 theta),
 *
 *     r_s = (c - q)/(c + q),   r_p = (m^2 c - q)/(m^2 c + q),   F = (|r_s|^2 + |r_p|^2)/2
 *
 * in complex numbers. Where m is 1 there is no surface and F = 0, also at c = 0, where the quotients are 0/0. An index that follows from
 * the reflectance r at normal incidence is (1 + sqrt r)/(1 - sqrt r) (Cook and Torrance 1982), 1e8 at most.
 */
#include "exact_arithmetic.h"

static num quotient_of_norms(complex_num a, complex_num b)
{
    num below = norm(b);
    return sign_of(below) > 0 ? over(norm(a), below) : number(0.0);
}

num exact_fresnel_of(num n, num k, num c)
{
    num none = number(0.0);
    complex_num m = complex_of(n, minus(none, k)), m_m = complex_times(m, m), c_c = complex_of(c, none);
    /* 1 - c^2 would need 600 digits for the least c. */
    complex_num q = complex_root(
        complex_plus(complex_minus(m_m, complex_of(number(1.0), none)), complex_of(square(c), none)));
    complex_num p = complex_times(m_m, c_c);
    num r_s = quotient_of_norms(complex_minus(c_c, q), complex_plus(c_c, q));
    num r_p = quotient_of_norms(complex_minus(p, q), complex_plus(p, q));
    return times(number(0.5), plus(r_s, r_p));
}

num exact_fresnel_index_of(num reflectance)
{
    num root = square_root(reflectance), one = number(1.0), most = number(1e8);
    if (mpfr_cmp(root, one) >= 0)
        return most;
    return least_of(most, over(plus(one, root), minus(one, root)));
}

void exact_reflectance(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    give(out[0], exact_fresnel_of(in[0], in[1], in[2]));
}

/* n and k of one channel: columns reflectance, n and k from the first on. */
static num reflected(mpfr_t in[], size_t first, size_t channel, num c)
{
    mpfr_ptr r = in[first + channel];
    if (mpfr_nan_p(r))
        return exact_fresnel_of(in[first + 3 + channel], in[first + 6 + channel], c);
    return exact_fresnel_of(exact_fresnel_index_of(r), number(0.0), c);
}

void exact_fresnel(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    num c = most_of(number(0.0), dot(unit(vector(in, 0)), unit(vector(in, 3))));
    for (size_t channel = 0; channel < 3; channel++)
        give(out[channel], reflected(in, 9, channel, c));
}

/* Cook and Torrance (1982), F D G/(4 N.V) with light and eye above the horizon. G of V-shaped grooves (Torrance and Sparrow 1967, Blinn
 * 1977); D is Beckmann's, exp(-tan^2/m^2)/(pi m^2 cos^4), or Trowbridge and Reitz's ellipsoid with R = 1/m,
 * R^2/(pi (cos^2 + R^2 sin^2)^2). */
static num facets(num cosine, num sine, num m, bool ellipsoid)
{
    num cc = square(cosine), ss = square(sine), mm = square(m), one = number(1.0);
    if (ellipsoid) {
        num rr = over(one, mm);
        return over(rr, times(pi(), square(plus(cc, times(rr, ss)))));
    }
    num exponent = over(ss, times(mm, cc));
    return over(exponential(minus(number(0.0), exponent)), times(pi(), times(mm, square(cc))));
}

void exact_cook_torrance(mpfr_t out[], mpfr_t in[])
{
    exact_begin();
    vec N = unit(vector(in, 0)), V = unit(vector(in, 3)), L = unit(vector(in, 6));
    num n_v = dot(N, V), n_l = dot(N, L);
    for (size_t channel = 0; channel < 3; channel++)
        mpfr_set_zero(out[channel], 1);
    if (sign_of(n_v) <= 0 || sign_of(n_l) <= 0)
        return;
    vec H = unit(sum(L, V));
    num n_h = dot(N, H), v_h = dot(V, H), two = number(2.0);
    num masking = over(times(two, times(n_h, n_v)), v_h), shadowing = over(times(two, times(n_h, n_l)), v_h);
    num G = least_of(number(1.0), least_of(masking, shadowing));
    num D = facets(n_h, length(cross(N, H)), in[18], mpfr_cmp_d(in[19], 0.5) > 0);
    num factor = over(times(D, G), times(number(4.0), n_v));
    for (size_t channel = 0; channel < 3; channel++)
        give(out[channel], times(factor, reflected(in, 9, channel, v_h)));
}
