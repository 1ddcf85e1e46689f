/* Exact highlights of polygon lights, for the rows of tests/hard/lights/lights.tsv, from MPFR. Nothing of src/ is included, nor its method:
 * src/ cuts the light into lines of fixed azimuth; here the light's boundary is walked along, by Green's theorem.
 *
 * With q = (V + L) projected on the tangent plane, psi its azimuth and delta the angle of the normal H = +-(V + L)/|V + L| from N, all of
 * L's directions over a polygon together give
 *
 *     pi L_o = integral over the polygon of D G d delta d psi = sum over its edges of the integral of F d psi,
 *     F(delta, psi) = integral from 0 to delta of D G along the radius of azimuth psi
 *
 * with the edges counterclockwise. F = 0 at delta = 0, so that the mirror direction needs no care.
 *
 *   - Attenuation on: polygons are cut at the horizon first; exact_lines_radial.c has F.
 *   - Attenuation off: G = 1 and F = U(delta) - 1/2. Where N.(V + L) < 0, H is -(V + L)/|V + L|: the radius has gone on over
 *     delta = pi/2 to the other side, and F = 1 - (U(delta) - 1/2). q turns once round 0 about L = -V too, with F of all radii together 1
 *     on the average of opposite ones: a polygon that holds -V gets pi more.
 *
 * Each edge, an arc of a great circle, is L = (a (1 - u^2) + 2 u e)/(1 + u^2), and is split where F breaks: these places are zeros of
 * polynomials in u (exact_lines_arc.c). Between them all is analytic and Gauss and Legendre's rule converges geometrically; a piece is
 * halved until rule and halves agree.
 */
#ifndef RL_TESTS_HARD_EXACT_LINES_H
#define RL_TESTS_HARD_EXACT_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h> /* first: mpfr.h declares its output functions only then */

#include <mpfr.h>

typedef mpfr_t vector[3];

/* How exactly: bits that everything is computed in, nodes of the rule, and the error wanted, relative to the answer. */
struct exact_effort {
    mpfr_prec_t bits;
    int nodes;
    double relative;
};

enum { RULE_MOST = 64, CORNERS_MOST = 24 };

struct rule {
    int n;
    mpfr_t node[RULE_MOST], weight[RULE_MOST]; /* on [-1, 1] */
};

/* The ellipsoid distribution and the view: what F depends on besides the place. */
struct lobe {
    bool attenuation;
    mpfr_t rr, kk;  /* R, and R^2 - 1, never 0 */
    mpfr_t k, norm; /* sqrt|kk|, and k/(2 atan k) or k/(2 atanh k) */
    vector V;
};

/* A convex spherical polygon, counterclockwise seen from outside. */
struct convex {
    int n;
    vector corner[CORNERS_MOST];
};

/* exact_lines_vector.c */
void vector_init(vector a);
void vector_clear(vector a);
void vector_set(vector to, vector a);
void vector_cross(vector to, vector a, vector b); /* `to` is neither of them */
void vector_dot(mpfr_t to, vector a, vector b);
void vector_unit(vector a);
void rule_make(struct rule *rule, int n);
void rule_clear(struct rule *rule);

/* exact_lines_radial.c. R = 1 is done as 1 + 2^-(two fifths of the bits). */
void lobe_make(struct lobe *lobe, mpfr_t rr, bool attenuation);
void lobe_clear(struct lobe *lobe);
/* F where q/|q| = (x, y)/|q| and H = (sine, cosine) along it; folded: on the far side of delta = pi/2. */
void lobe_radial(mpfr_t out, struct lobe *lobe, mpfr_t v_t, mpfr_t sine, mpfr_t cosine, bool folded);

/* exact_lines_arc.c: adds the integral of F d psi along the arc from one corner to the other, to within `tolerance`. */
void arc_integrate(mpfr_t sum, struct lobe *lobe, struct rule *rule, vector from, vector to,
                   mpfr_t tolerance);

/* exact_lines_polygon.c */
void convex_init(struct convex *c);
void convex_clear(struct convex *c);
/* Keeps what lies where m.L > 0. */
void convex_cut(struct convex *c, vector m);
/* The part of a that lies in b too. */
void convex_intersect(struct convex *a, struct convex *b);
/* L_o of radiance 1, to within tolerance/pi. */
void convex_highlight(mpfr_t out, struct lobe *lobe, struct rule *rule, struct convex *c, mpfr_t tolerance);

/* exact_lines_scene.c. A row's numbers: R_r, attenuation (0 or 1), P, N, V, lights. */
enum { SCENE_LIGHTS = 2, SCENE_CORNERS = 4, SCENE_NUMBERS = 11 + SCENE_LIGHTS * SCENE_CORNERS * 3 };

struct scene {
    int n_lights, n_corners[SCENE_LIGHTS];
    /* [0] R_r, [1] attenuation, then P, N and V; SCENE_NUMBERS in all, of which those of corners left out are not looked at. */
    mpfr_t number[SCENE_NUMBERS];
};

size_t scene_corner(int light, int corner); /* the index of its first coordinate */
void scene_highlight(mpfr_t out, const struct scene *scene, const struct exact_effort *effort);

#endif
