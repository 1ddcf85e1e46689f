/* Measures normal maps: do their texels, as the GPU has them, follow the distribution they were drawn from? */
#include <math.h>
#include <stdlib.h>

#include "measure/goodness.h"
#include "studies/distribution.h"

/* Fine enough that the Kolmogorov distance, at best 0.001 with the largest maps, is not about them. */
enum { FINE_BINS = 1 << 16, BLOCK = 1 << 14 };

/* A mean of up to some millions of terms of size 1: plain sums err by 1e-10 at most. */
struct moments {
    double n, sum, squares;
};

static void moments_add(struct moments *m, const double *x, size_t n)
{
    double sum = 0.0, squares = 0.0;
#pragma omp simd reduction(+ : sum, squares)
    for (size_t i = 0; i < n; i++) {
        sum += x[i];
        squares += x[i] * x[i];
    }
    m->n += (double)n;
    m->sum += sum;
    m->squares += squares;
}

static double moments_mean(const struct moments *m)
{
    return m->sum / m->n;
}

/* Standard error of the mean. */
static double moments_error(const struct moments *m)
{
    double mean = moments_mean(m);
    return sqrt(fmax(m->squares / m->n - mean * mean, 0.0) / m->n);
}

/* Normals of a block of texels as the shader has them, as unit vectors; how storing moved their tangential components; and where the
 * cdf of D (distribution_truth.c) and theta/pi put them. */
enum quantity { ALONG, TANGENT, BITANGENT, TANGENT_MOVED, BITANGENT_MOVED, U, THETA, QUANTITIES };
typedef double block[QUANTITIES][BLOCK];

/* What is gathered over the texels of a map. */
struct tally {
    const struct rl_distribution_truth *d;
    struct rl_goodness u, theta;
    struct moments mean_u;
    struct moments normal[3]; /* components of unit normals: along N, and tangential */
    struct moments moved[2];  /* tangential components less those before storing */
};

/* A texel as the shader decodes it, 2 t - 1 in single precision, made a unit vector: the shader's sum does not depend on the
 * length. delta and theta in [0, pi) are those of DESIGN's H; where y = z = 0, theta is 0. */
static void place_texel(block b, size_t i, const struct rl_distribution_truth *d, const float texel[4],
                        const struct rl_microfacet *exact)
{
    float decoded[3];
    for (int c = 0; c < 3; c++)
        decoded[c] = 2.0f * texel[c] - 1.0f;
    rl_vec3 h = v3_normalize(v3(decoded[0], decoded[1], decoded[2]));
    double theta = atan2(h.z, h.y), sin_delta = sqrt(h.y * h.y + h.z * h.z);
    if (theta < 0.0 || theta >= RL_PI) {
        theta += theta < 0.0 ? RL_PI : -RL_PI;
        sin_delta = -sin_delta;
    }
    b[ALONG][i] = h.x;
    b[TANGENT][i] = h.y;
    b[BITANGENT][i] = h.z;
    b[TANGENT_MOVED][i] = h.y - exact->y;
    b[BITANGENT_MOVED][i] = h.z - exact->z;
    b[U][i] = rl_distribution_truth_cdf(d, sin_delta, fmax(h.x, 0.0));
    b[THETA][i] = theta / RL_PI;
}

static void tally_block(struct tally *t, block b, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        rl_goodness_add(&t->u, b[U][i]);
        rl_goodness_add(&t->theta, b[THETA][i]);
    }
    moments_add(&t->mean_u, b[U], n);
    for (int c = 0; c < 3; c++)
        moments_add(&t->normal[c], b[ALONG + c], n);
    for (int c = 0; c < 2; c++)
        moments_add(&t->moved[c], b[TANGENT_MOVED + c], n);
}

/* The length of a mean of two components: chi with two degrees of freedom reaches 2.448 standard errors in 95 % of cases. */
static struct rl_interval length_of(const struct moments *a, const struct moments *b, double scale)
{
    double length = hypot(moments_mean(a), moments_mean(b)) * scale;
    double room = 2.448 * fmax(moments_error(a), moments_error(b)) * scale;
    return (struct rl_interval){length, fmax(length - room, 0.0), length + room};
}

/* Where |2U - 1| reaches the quantile q, from the bins' ends and a line between. */
static double folded_quantile(const struct rl_goodness *u, double q)
{
    size_t half = u->n_bins / 2;
    double wanted = q * (double)u->n, below = 0.0;
    for (size_t i = 0; i < half; i++) {
        double here = (double)(u->count[half + i] + u->count[half - 1 - i]);
        if (below + here >= wanted && here > 0.0)
            return ((double)i + (wanted - below) / here) / (double)half;
        below += here;
    }
    return 1.0;
}

static double width_at(const struct tally *t, double q)
{
    double folded = folded_quantile(&t->u, q);
    return rl_distribution_truth_quantile(t->d, folded) / t->d->median;
}

/* The median |delta| over that of D. Its interval: order statistics, by the normal approximation of the binomial. */
static struct rl_interval width_of(const struct tally *t)
{
    double room = 0.98 / sqrt((double)t->u.n);
    return (struct rl_interval){width_at(t, 0.5), width_at(t, 0.5 - room), width_at(t, 0.5 + room)};
}

static int add_fit(struct rl_record *r, const struct tally *t, struct rl_error *error)
{
    struct rl_chi_square delta = rl_goodness_chi_square(&t->u, RL_DISTRIBUTION_BINS);
    struct rl_chi_square theta = rl_goodness_chi_square(&t->theta, RL_DISTRIBUTION_BINS);
    const struct {
        const char *name;
        double value;
    } row[] = {
        {"texels", (double)t->u.n},
        {"chi2_delta", delta.statistic},
        {"chi2_theta", theta.statistic},
        {"freedom", delta.freedom},
        {"p_delta", delta.p},
        {"p_theta", theta.p},
        {"phi2_delta", delta.phi2},
        {"phi2_theta", theta.phi2},
    };
    int status = RL_OK;
    for (size_t i = 0; i < sizeof row / sizeof row[0] && status == RL_OK; i++)
        status = rl_record_add_exact(r, row[i].name, row[i].value, "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "misfit_delta", rl_goodness_misfit(&t->u, RL_DISTRIBUTION_BINS, 0.95), "1",
                               error);
    if (status == RL_OK)
        status = rl_record_add(r, "misfit_theta", rl_goodness_misfit(&t->theta, RL_DISTRIBUTION_BINS, 0.95),
                               "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "kolmogorov", rl_goodness_kolmogorov(&t->u, 0.95), "1", error);
    double ratio[RL_DISTRIBUTION_BINS];
    rl_goodness_ratios(ratio, &t->u, RL_DISTRIBUTION_BINS);
    if (status == RL_OK && rl_parameters_match(r->parameters, "keep=1"))
        status = rl_record_series_add(r, "delta_bins", ratio, RL_DISTRIBUTION_BINS, error);
    return status;
}

static int add_moments(struct rl_record *r, const struct tally *t, struct rl_error *error)
{
    double mean = moments_mean(&t->mean_u), room = 1.96 * moments_error(&t->mean_u);
    double along = moments_mean(&t->normal[0]); /* the mean normal's length is near it: a tilt is small */
    int status = rl_record_add(r, "mean_u", (struct rl_interval){mean, mean - room, mean + room}, "1", error);
    if (status == RL_OK)
        status =
            rl_record_add(r, "mean_tilt", length_of(&t->normal[1], &t->normal[2], 1.0 / along), "rad", error);
    if (status == RL_OK)
        status = rl_record_add(r, "tilt", length_of(&t->moved[0], &t->moved[1], 1.0 / along), "rad", error);
    if (status == RL_OK)
        status = rl_record_add(r, "width", width_of(t), "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "d_median", t->d->median, "rad", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "d_rms_sine", t->d->rms_sine, "1", error);
    return status;
}

/* The normals of one seed, R_r and size before they are stored. */
static int draw_exact(struct rl_microfacet **exact, const struct rl_plan_normal_map *map,
                      const struct rl_settings *settings, struct rl_error *error)
{
    long n = (long)settings->normal_size * settings->normal_size;
    struct rl_ellipsoid e = rl_ellipsoid_make(map->rr);
    struct rl_microfacet *h = *exact = malloc((size_t)n * sizeof **exact);
    if (!h)
        return rl_fail_memory(error, "a map's normals");
#pragma omp parallel for schedule(static)
    for (long i = 0; i < n; i++)
        h[i] = map->method->texel(&e, settings->seed, (uint64_t)i);
    return RL_OK;
}

/* Room for the counts, then texels by the block: the distribution's cdf at each, which is the truth here, then the counting. */
static int tally_map(struct tally *t, const float *texels, const struct rl_microfacet *exact, size_t n,
                     struct rl_spent *spent, struct rl_error *error)
{
    int status = rl_goodness_make(&t->u, FINE_BINS, error);
    if (status == RL_OK)
        status = rl_goodness_make(&t->theta, FINE_BINS, error);
    block *b = malloc(sizeof *b);
    if (status == RL_OK && !b)
        status = rl_fail_memory(error, "a map's normals");
    for (size_t at = 0; at < n && status == RL_OK; at += BLOCK) {
        size_t here = n - at < BLOCK ? n - at : BLOCK;
        enum rl_spent_kind outer = rl_spent_on(spent, RL_SPENT_REFERENCE);
#pragma omp parallel for schedule(static)
        for (size_t i = 0; i < here; i++)
            place_texel(*b, i, t->d, texels + 4 * (at + i), &exact[at + i]);
        rl_spent_on(spent, outer);
        tally_block(t, *b, here);
    }
    free(b);
    return status;
}

static int measure_map(struct rl_record *r, const struct rl_plan_normal_map *map,
                       const struct rl_settings *settings, const struct rl_microfacet *exact,
                       const struct rl_distribution_truth *d, struct rl_bench *bench, struct rl_error *error)
{
    struct tally t = {.d = d};
    float *texels;
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    int status = rl_gpu_normal_map_read(&texels, bench->gpu, map, settings, error);
    rl_spent_on(&bench->spent, outer);
    if (status == RL_OK)
        status = tally_map(&t, texels, exact, (size_t)settings->normal_size * (size_t)settings->normal_size,
                           &bench->spent, error);
    free(texels);
    if (status == RL_OK)
        status = add_fit(r, &t, error);
    if (status == RL_OK)
        status = add_moments(r, &t, error);
    rl_goodness_clear(&t.u);
    rl_goodness_clear(&t.theta);
    return status;
}

int rl_distribution_measure_maps(struct rl_record *records, size_t n, struct rl_bench *bench,
                                 struct rl_error *error)
{
    struct rl_settings settings;
    struct rl_microfacet *exact = NULL;
    struct rl_distribution_truth d;
    int status = rl_bench_settings(&settings, records[0].parameters, error);
    if (status != RL_OK)
        return status;
    const struct rl_plan_normal_map map = {.rr = settings.rr, .method = rl_method_find("random")};
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    status = draw_exact(&exact, &map, &settings, error);
    rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
    rl_distribution_truth_make(&d, rl_parameter_number(records[0].parameters, "rr"));
    rl_spent_on(&bench->spent, outer);
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        status = rl_bench_settings(&settings, records[i].parameters, error);
        if (status == RL_OK)
            status = measure_map(&records[i], &map, &settings, exact, &d, bench, error);
    }
    free(exact);
    return status;
}
