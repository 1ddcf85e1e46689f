/* Exact answers for the catalogue of hard cases, from MPFR with EXACT_BITS bits.
 *
 * One row of exact_functions for each file tests/hard/NAME.tsv; NAME is the probe's. Formulas are written here anew, from their sources,
 * as plainly as the precision allows: nothing of src/ is included, so that no mistake is made twice. To add a function, write it in an
 * exact_*.c, declare it below and give it a row in exact_table.c.
 */
#ifndef RL_TESTS_HARD_EXACT_H
#define RL_TESTS_HARD_EXACT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h> /* first: mpfr.h declares its output functions only then */

#include <mpfr.h>

/* 120 digits: the worst cancellation of the catalogue is that of R_r = 1e12, some 50 digits in formulas written plainly. Where arguments of
 * 1e-300 count beside 1, functions take more bits of their own. */
enum { EXACT_BITS = 400, EXACT_IN_MAX = 40, EXACT_OUT_MAX = 9, EXACT_RANGES = 4 };

struct exact_function {
    const char *name;
    size_t n_in, n_out;
    size_t n_directions; /* triples that begin the arguments, of which only the direction counts */
    size_t
        n_points; /* triples that follow them: positions, of which only differences and sizes to each other count */
    const char *out[EXACT_OUT_MAX];
    bool whole_numbers; /* arguments are whole numbers: exact, so that no bound allows for their rounding */
    bool whole_answers; /* answers as well: both precisions are asked for the answer itself */
    /* Of the first arguments, where an end of it is no number of single precision; both 0: none such. */
    struct exact_range {
        double low, high;
    } range[EXACT_RANGES];
    /* Or NULL. Of the size of what the answer is made of where that may be more than it: double precision is asked for one unit in the last
     * place of it at most. */
    double (*whole)(mpfr_t in[]);
    /* Or NULL. Whether arguments of so many bits are within their rounding of where the answer jumps: random rows are none of these, where
     * either answer is right. */
    bool (*undecided)(mpfr_t in[], int bits);
    /* An argument that was left out is NaN. Arguments may lie a few units in the last place beyond their range. */
    void (*evaluate)(mpfr_t out[], mpfr_t in[]);
};

extern const struct exact_function exact_functions[];
extern const size_t exact_n_functions;

/* What a 1 is rounded by in the precision of the arguments that are evaluated: 2^-52 or 2^-23. */
extern double exact_unit;

/* Of one row. [0]: of double precision, [1]: of single. */
struct exact_answer {
    mpfr_t in[EXACT_IN_MAX], out[2][EXACT_OUT_MAX], moves[2][EXACT_OUT_MAX];
    double bound[2][EXACT_OUT_MAX];
    bool strict; /* whoever makes it may set it: no bound is as wide as what the arguments' rounding does */
};

/* exact_answer.c. The two precisions by their bits; an argument of a row as one of them has it. False: an answer is not finite. */
enum { EXACT_DOUBLE = 53, EXACT_SINGLE = 24 };
void exact_argument(mpfr_t to, const struct exact_function *f, size_t i, double x, int bits);
void exact_answer_init(struct exact_answer *a, const struct exact_function *f);
bool exact_answer_make(struct exact_answer *a, const struct exact_function *f, const double *row);
void exact_answer_clear(struct exact_answer *a, const struct exact_function *f);

/* exact_map.c: the i-th map's name, NULL past the last; its file. */
const char *exact_map_name(size_t i);
void exact_map_write(FILE *to, size_t i);

/* exact_ellipsoid.c */
void exact_ellipsoid_pdf(mpfr_t out[], mpfr_t in[]);
void exact_ellipsoid_cdf(mpfr_t out[], mpfr_t in[]);
void exact_ellipsoid_inverse(mpfr_t out[], mpfr_t in[]);

/* exact_effects.c, exact_highlights.c, exact_fresnel.c, exact_fur.c */
void exact_ambient(mpfr_t out[], mpfr_t in[]);
void exact_diffuse(mpfr_t out[], mpfr_t in[]);
void exact_diffuse_area_polygon(mpfr_t out[], mpfr_t in[]);
double exact_diffuse_area_whole(mpfr_t in[]);
bool exact_in_plane(mpfr_t in[], int bits);
void exact_point_light(mpfr_t out[], mpfr_t in[]);
void exact_phong(mpfr_t out[], mpfr_t in[]);
bool exact_light_level(mpfr_t in[], int bits); /* N.L is 0 but for rounding */
void exact_blinn(mpfr_t out[], mpfr_t in[]);
bool exact_either_level(mpfr_t in[], int bits); /* or N.V is */
void exact_reflectance(mpfr_t out[], mpfr_t in[]);
void exact_fresnel(mpfr_t out[], mpfr_t in[]);
void exact_cook_torrance(mpfr_t out[], mpfr_t in[]);
void exact_fur_sine(mpfr_t out[], mpfr_t in[]);
void exact_fur_cone(mpfr_t out[], mpfr_t in[]);
void exact_fur_cone_printed(mpfr_t out[], mpfr_t in[]);
void exact_fur_half(mpfr_t out[], mpfr_t in[]);
double exact_fur_kappa_whole(mpfr_t in[]);
void exact_fur_kappa(mpfr_t out[], mpfr_t in[]);
void exact_kajiya(mpfr_t out[], mpfr_t in[]);
void exact_kajiya_printed(mpfr_t out[], mpfr_t in[]);
void exact_lengyel(mpfr_t out[], mpfr_t in[]);
void exact_goldman(mpfr_t out[], mpfr_t in[]);
void exact_goldman_printed(mpfr_t out[], mpfr_t in[]);

/* exact_model.c */
void exact_frame(mpfr_t out[], mpfr_t in[]);
void exact_frame_printed(mpfr_t out[], mpfr_t in[]);
void exact_attenuation(mpfr_t out[], mpfr_t in[]);
void exact_facets_beckmann(mpfr_t out[], mpfr_t in[]);
void exact_facets_ellipsoid(mpfr_t out[], mpfr_t in[]);
void exact_angle(mpfr_t out[], mpfr_t in[]);
void exact_direction(mpfr_t out[], mpfr_t in[]);
void exact_mirror(mpfr_t out[], mpfr_t in[]);
void exact_luminance(mpfr_t out[], mpfr_t in[]);
void exact_reflectance_index(mpfr_t out[], mpfr_t in[]);

/* exact_terms.c */
void exact_random_bits(mpfr_t out[], mpfr_t in[]);
void exact_random_uniform(mpfr_t out[], mpfr_t in[]);
void exact_flux(mpfr_t out[], mpfr_t in[]);
void exact_sine_squared(mpfr_t out[], mpfr_t in[]);
void exact_half(mpfr_t out[], mpfr_t in[]);
void exact_lobe(mpfr_t out[], mpfr_t in[]);
void exact_crossing(mpfr_t out[], mpfr_t in[]);

#endif
