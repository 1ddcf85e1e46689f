/* From a row's numbers to convex spherical polygons, and the highlight of all of them together. */
#include "exact_lines.h"

#include <math.h>

/* A light as seen: one convex polygon, or two triangles of which the second may be taken away. */
enum { PARTS_MOST = 2 };
struct seen {
    int n, sign[PARTS_MOST];
    struct convex part[PARTS_MOST];
};

size_t scene_corner(int light, int corner)
{
    return 11 + 3 * (size_t)(light * SCENE_CORNERS + corner);
}

static void seen_init(struct seen *s)
{
    s->n = 0;
    for (int i = 0; i < PARTS_MOST; i++)
        convex_init(&s->part[i]);
}

static void seen_clear(struct seen *s)
{
    for (int i = 0; i < PARTS_MOST; i++)
        convex_clear(&s->part[i]);
}

/* Rows of an orthonormal frame whose third is N. */
static void make_frame(vector frame[3], mpfr_srcptr N)
{
    int axis = 0;
    for (int i = 0; i < 3; i++) {
        mpfr_set(frame[2][i], &N[i], MPFR_RNDN);
        axis = mpfr_cmpabs(&N[i], &N[axis]) < 0 ? i : axis;
    }
    vector_unit(frame[2]);
    for (int i = 0; i < 3; i++)
        mpfr_set_ui(frame[0][i], i == axis, MPFR_RNDN);
    vector_cross(frame[1], frame[2], frame[0]);
    vector_unit(frame[1]);
    vector_cross(frame[0], frame[1], frame[2]);
}

static void to_frame(vector out, vector frame[3], vector a)
{
    for (int i = 0; i < 3; i++)
        vector_dot(out[i], frame[i], a);
}

/* The sign of a.(b x c), 0 where it is the rounding of these unit vectors. */
static int turn(vector a, vector b, vector c)
{
    vector m;
    mpfr_t det;
    vector_init(m);
    mpfr_init(det);
    vector_cross(m, b, c);
    vector_dot(det, a, m);
    int sign = mpfr_sgn(det);
    if (sign != 0 && mpfr_get_exp(det) < -(mpfr_exp_t)(mpfr_get_default_prec() * 3 / 4))
        sign = 0;
    vector_clear(m);
    mpfr_clear(det);
    return sign;
}

/* Adds the corners given in the order of their turn, unless they are seen edge-on; returns the turn. */
static int add_part(struct seen *s, vector corner[], const int index[], int n)
{
    int sign = 0;
    for (int i = 0; i + 2 < n && sign == 0; i++)
        sign = turn(corner[index[0]], corner[index[i + 1]], corner[index[i + 2]]);
    if (sign == 0)
        return 0;
    struct convex *part = &s->part[s->n];
    for (int i = 0; i < n; i++)
        vector_set(part->corner[i], corner[index[sign > 0 ? i : n - 1 - i]]);
    part->n = n;
    s->sign[s->n++] = sign;
    return sign;
}

/* Whether every three corners in a row turn the same way, or not at all. */
static bool is_convex(vector corner[], int n)
{
    int least = 1, most = -1;
    for (int i = 0; i < n; i++) {
        int sign = turn(corner[i], corner[(i + 1) % n], corner[(i + 2) % n]);
        least = sign < least ? sign : least;
        most = sign > most ? sign : most;
    }
    return least >= 0 || most <= 0;
}

static void see(struct seen *s, const struct scene *scene, int light, vector frame[3])
{
    static const int whole[] = {0, 1, 2, 3}, other[] = {0, 2, 3};
    vector corner[SCENE_CORNERS], p;
    int n = scene->n_corners[light];
    bool touching = false;
    vector_init(p);
    for (int i = 0; i < SCENE_CORNERS; i++)
        vector_init(corner[i]);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < 3; j++)
            mpfr_sub(p[j], scene->number[scene_corner(light, i) + (size_t)j], scene->number[2 + j],
                     MPFR_RNDN);
        touching = touching || (mpfr_zero_p(p[0]) && mpfr_zero_p(p[1]) && mpfr_zero_p(p[2]));
        to_frame(corner[i], frame, p);
        if (!touching)
            vector_unit(corner[i]);
    }
    if (!touching && (n == 3 || is_convex(corner, n))) {
        if (add_part(s, corner, whole, n))
            s->sign[0] = 1;
    } else if (!touching) {
        add_part(s, corner, whole, 3);
        add_part(s, corner, other, 3);
        /* Whichever is larger, it is the one that is lit. */
        if (s->n == 2)
            s->sign[1] *= s->sign[0];
        if (s->n > 0)
            s->sign[0] = 1;
    }
    vector_clear(p);
    for (int i = 0; i < SCENE_CORNERS; i++)
        vector_clear(corner[i]);
}

static void add_light(mpfr_t sum, struct seen *s, int sign, struct lobe *lobe, struct rule *rule,
                      mpfr_t tolerance)
{
    mpfr_t part;
    mpfr_init(part);
    for (int i = 0; i < s->n; i++) {
        convex_highlight(part, lobe, rule, &s->part[i], tolerance);
        (s->sign[i] * sign < 0 ? mpfr_sub : mpfr_add)(sum, sum, part, MPFR_RNDN);
    }
    mpfr_clear(part);
}

/* One light, or two that cover what either does: the sum less what both cover. */
static void highlight_once(mpfr_t out, const struct scene *scene, vector frame[3], struct lobe *lobe,
                           struct rule *rule, mpfr_t tolerance)
{
    mpfr_set_zero(out, 1);
    for (int i = 0; i < scene->n_lights; i++) {
        struct seen s;
        seen_init(&s);
        see(&s, scene, i, frame);
        add_light(out, &s, 1, lobe, rule, tolerance);
        seen_clear(&s);
    }
    if (scene->n_lights == 2) {
        struct seen a, b;
        seen_init(&a);
        seen_init(&b);
        see(&a, scene, 0, frame);
        see(&b, scene, 1, frame);
        if (a.n > 0 && b.n > 0) {
            convex_intersect(&a.part[0], &b.part[0]);
            add_light(out, &a, -1, lobe, rule, tolerance);
        }
        seen_clear(&a);
        seen_clear(&b);
    }
    mpfr_abs(out, out, MPFR_RNDN);
}

/* Again with a smaller tolerance until it is as small as the answer wants it. */
static void highlight_to(mpfr_t out, const struct scene *scene, vector frame[3], struct lobe *lobe,
                         struct rule *rule, double relative)
{
    enum { TIMES = 4 };
    mpfr_t tolerance, wanted;
    mpfr_inits(tolerance, wanted, (mpfr_ptr)0);
    mpfr_set_d(tolerance, 0.01 * relative, MPFR_RNDN);
    for (int i = 0; i < TIMES; i++) {
        highlight_once(out, scene, frame, lobe, rule, tolerance);
        mpfr_mul_d(wanted, out, relative, MPFR_RNDN);
        if (mpfr_zero_p(out) || mpfr_lessequal_p(tolerance, wanted))
            break;
        mpfr_mul_d(tolerance, wanted, 0.01, MPFR_RNDN);
    }
    mpfr_clears(tolerance, wanted, (mpfr_ptr)0);
}

void scene_highlight(mpfr_t out, const struct scene *scene, const struct exact_effort *effort)
{
    vector frame[3], V;
    struct lobe lobe;
    struct rule rule;
    mpfr_set_default_prec(effort->bits);
    mpfr_set_prec(out, effort->bits);
    rule_make(&rule, effort->nodes);
    for (int i = 0; i < 3; i++)
        vector_init(frame[i]);
    vector_init(V);
    lobe_make(&lobe, (mpfr_ptr)scene->number[0], mpfr_sgn(scene->number[1]) != 0);
    make_frame(frame, scene->number[5]);
    for (int i = 0; i < 3; i++)
        mpfr_set(V[i], scene->number[8 + i], MPFR_RNDN);
    vector_unit(V);
    to_frame(lobe.V, frame, V);
    mpfr_set_zero(out, 1);
    if (mpfr_sgn(lobe.V[2]) > 0)
        highlight_to(out, scene, frame, &lobe, &rule, effort->relative);
    for (int i = 0; i < 3; i++)
        vector_clear(frame[i]);
    vector_clear(V);
    lobe_clear(&lobe);
    rule_clear(&rule);
}
