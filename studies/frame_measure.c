/* Measures what the paper's tangent frame, as printed, does to a lobe and to a highlight. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "measure/metrics.h"
#include "measure/statistics.h"
#include "model/frame.h"
#include "model/random.h"
#include "reference/integrator.h"
#include "studies/frame.h"

enum { POINTS_MAX = 65536, SAMPLES_MAX = 65536, CORNERS = 4 };

static const double step_of_8_bits = 1.0 / 255.0;

/* The i-th of n points spread evenly over the sphere: a golden-angle spiral, each point for the same area. */
static rl_vec3 sphere_point(size_t i, size_t n)
{
    double z = 1.0 - (2.0 * (double)i + 1.0) / (double)n, r = sqrt(1.0 - z * z);
    double longitude = RL_PI * (3.0 - sqrt(5.0)) * (double)i;
    return v3(r * cos(longitude), r * sin(longitude), z);
}

/* Length of the printed tangents. */
static double printed_length(rl_vec3 N)
{
    return hypot(N.y, N.z);
}

/* What sampling needs to be told, and room for what it gives. */
struct sampling {
    struct rl_ellipsoid e;
    size_t samples;
    double *delta;
    struct rl_spent *spent;
};

/* |delta| of the normals drawn about N in this frame: normals `stream` on of the random numbers. */
static void draw(const struct sampling *s, enum rl_frame_kind kind, rl_vec3 N, uint64_t stream)
{
    struct rl_frame frame = rl_frame_make(kind, N);
    for (size_t i = 0; i < s->samples; i++) {
        uint64_t index = 2 * (stream * s->samples + i);
        struct rl_delta d = rl_ellipsoid_inverse(&s->e, rl_random_uniform(1, index));
        rl_vec3 H = rl_frame_microfacet_normal(&frame, d.sin_delta, d.cos_delta,
                                               RL_PI * rl_random_uniform(1, index + 1));
        /* The angle from its tangent: the cosine of a small angle says little about it. */
        s->delta[i] = atan2(v3_length(v3_cross(N, H)), v3_dot(N, H));
    }
}

static void swap(double *a, double *b)
{
    double kept = *a;
    *a = *b;
    *b = kept;
}

/* The value that would stand at `k` if all were sorted; smaller ones come to stand before it, larger ones behind (Hoare 1961). */
static double select_value(double *value, size_t n, size_t k)
{
    size_t low = 0, high = n - 1;
    while (low < high) {
        double pivot = value[low + (high - low) / 2];
        size_t i = low, j = high;
        for (;;) {
            while (value[i] < pivot)
                i++;
            while (value[j] > pivot)
                j--;
            if (i >= j)
                break;
            swap(&value[i++], &value[j--]);
        }
        /* Up to j nothing is larger than the pivot, behind it nothing smaller. */
        if (k <= j)
            high = j;
        else
            low = j + 1;
    }
    return value[k];
}

/* Quantiles of |delta|. */
struct width {
    double median, q90;
};

static struct width width_of(const struct sampling *s, enum rl_frame_kind kind, rl_vec3 N, uint64_t stream)
{
    enum rl_spent_kind outer = rl_spent_on(s->spent, RL_SPENT_MEASURED);
    draw(s, kind, N, stream);
    rl_spent_on(s->spent, outer);
    size_t n = s->samples, middle = (size_t)(0.5 * (double)n), upper = (size_t)(0.9 * (double)n);
    double median = select_value(s->delta, n, middle);
    return (struct width){median, select_value(s->delta + middle, n - middle, upper - middle)};
}

/* Printed over orthonormal, each with random numbers of its own. */
static struct width ratio_at(const struct sampling *s, rl_vec3 N, uint64_t at)
{
    struct width printed = width_of(s, RL_FRAME_PRINTED, N, 2 * at);
    struct width orthonormal = width_of(s, RL_FRAME_ORTHONORMAL, N, 2 * at + 1);
    return (struct width){printed.median / orthonormal.median, printed.q90 / orthonormal.q90};
}

/* The same by the formula: the printed frame moves delta to delta' with tan(delta') = l tan(delta), so quantiles too. */
static double expected_ratio(const struct rl_ellipsoid *e, double l)
{
    struct rl_delta d = rl_ellipsoid_inverse(e, 0.75); /* half of all |delta| are below it */
    return atan2(l * d.sin_delta, d.cos_delta) / d.delta;
}

/* What is gathered of each N. */
struct lobe {
    size_t n;
    double *median, *q90,
        *log_against; /* the logarithm of measured over expected: its mean is not drawn up by noise */
};

static int add_lobe(struct rl_record *r, const struct lobe *lobe, struct rl_error *error)
{
    double worst = 0.0, half = 0.0, n = (double)lobe->n;
    for (size_t i = 0; i < lobe->n; i++) {
        worst = fmax(worst, fabs(expm1(lobe->log_against[i])));
        half += lobe->median[i] < 0.5;
    }
    const struct rl_interval against = rl_mean_interval(lobe->log_against, lobe->n, 0.95);
    /* A share of n points: Wilson 1927, which keeps within [0, 1]. */
    double p = half / n, z = 1.96, middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    double room = z / (1.0 + z * z / n) * sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    int status = rl_record_add(r, "width", rl_mean_interval(lobe->median, lobe->n, 0.95), "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "width90", rl_mean_interval(lobe->q90, lobe->n, 0.95), "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "against_formula",
                               (struct rl_interval){exp(against.value), exp(against.low), exp(against.high)},
                               "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "worst", worst, "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "half", (struct rl_interval){p, middle - room, middle + room}, "1", error);
    return status;
}

/* Centres of a grid in latitude and longitude, z up: the printed frame's bad directions +-x lie on the equator. */
static int add_map(struct rl_record *r, const struct sampling *s, size_t columns, struct rl_error *error)
{
    size_t rows = columns / 2;
    double *map = malloc(rows * columns * sizeof *map);
    if (!map)
        return rl_fail_memory(error, "a map");
    for (size_t i = 0; i < rows * columns; i++) {
        size_t row = i / columns, column = i % columns;
        double latitude = RL_PI * (((double)row + 0.5) / (double)rows - 0.5);
        double longitude = 2.0 * RL_PI * (((double)column + 0.5) / (double)columns - 0.5);
        rl_vec3 N = v3(cos(latitude) * cos(longitude), cos(latitude) * sin(longitude), sin(latitude));
        map[i] = ratio_at(s, N, POINTS_MAX + i).median;
    }
    int status = rl_record_series_add(r, "map", map, rows * columns, error);
    free(map);
    return status;
}

static int measure_lobe(struct rl_record *r, size_t points, struct rl_spent *spent, struct rl_error *error)
{
    double samples = rl_parameter_number(r->parameters, "samples");
    double columns = rl_parameter_number(r->parameters, "columns");
    if (!(samples >= 10.0 && samples <= SAMPLES_MAX) || !(columns >= 0.0 && columns <= 360.0))
        return rl_fail(error, RL_ERR_INPUT, "samples=%g columns=%g: expected 10 to %d, 0 to 360", samples,
                       columns, SAMPLES_MAX);
    struct sampling s = {.e = rl_ellipsoid_make(rl_parameter_number(r->parameters, "rr")),
                         .samples = (size_t)samples,
                         .spent = spent};
    double *room = malloc((3 * points + s.samples) * sizeof *room);
    if (!room)
        return rl_fail_memory(error, "a lobe's normals");
    struct lobe lobe = {points, room, room + points, room + 2 * points};
    s.delta = room + 3 * points;
    for (size_t i = 0; i < points; i++) {
        rl_vec3 N = sphere_point(i, points);
        struct width ratio = ratio_at(&s, N, i);
        lobe.median[i] = ratio.median;
        lobe.q90[i] = ratio.q90;
        lobe.log_against[i] = log(ratio.median / expected_ratio(&s.e, printed_length(N)));
    }
    int status = add_lobe(r, &lobe, error);
    if (status == RL_OK && columns >= 2.0)
        status = add_map(r, &s, (size_t)columns, error);
    free(room);
    return status;
}

/* A square light of half side 1/2 at distance 2 about a direction in the plane of N and the eye, `beside` radians from the mirror
 * direction, which is 30 degrees from N. Everything turns with N: with a frame that is a rotation L_o is the same everywhere. */
static int make_light(struct rl_light_set **set, struct rl_surface *surface, rl_vec3 N, double beside,
                      struct rl_error *error)
{
    struct rl_frame turn = rl_frame_make(RL_FRAME_ORTHONORMAL, N);
    double eye = RL_PI / 6.0, at = eye + beside;
    *surface = (struct rl_surface){.N = N, .V = v3_madd(v3_scale(cos(eye), N), -sin(eye), turn.T)};
    rl_vec3 centre = v3_scale(2.0, v3_madd(v3_scale(cos(at), N), sin(at), turn.T));
    rl_vec3 side = v3_madd(v3_scale(-sin(at), N), cos(at), turn.T);
    rl_vec3 corner[CORNERS];
    for (int i = 0; i < CORNERS; i++)
        corner[i] = v3_madd(v3_madd(centre, i == 0 || i == 3 ? -0.5 : 0.5, side), i < 2 ? -0.5 : 0.5, turn.B);
    const rl_vec3 *const polygon[] = {corner};
    const size_t corners[] = {CORNERS};
    return rl_light_set_from_polygons(set, polygon, corners, 1, error);
}

/* L_o at N in both frames, with what the reference may be off by. */
static int highlights(double value[2], double *room, const struct rl_ellipsoid *e, rl_vec3 N, double beside,
                      double tolerance, struct rl_error *error)
{
    struct rl_light_set *set;
    struct rl_surface surface;
    bool converged = true;
    int status = make_light(&set, &surface, N, beside, error);
    if (status != RL_OK)
        return status;
    for (int k = 0; k < 2; k++) {
        const struct rl_integrate_options options = {.attenuation = true,
                                                     .frame = k ? RL_FRAME_PRINTED : RL_FRAME_ORTHONORMAL,
                                                     .tolerance = tolerance,
                                                     .simd = rl_simd_best()};
        struct rl_estimate estimate;
        rl_integrate_lines(&estimate, &surface, e, set, &options);
        value[k] = estimate.value[0];
        *room = fmax(*room, estimate.error[0]);
        converged = converged && estimate.converged;
    }
    rl_light_set_free(set);
    if (!converged)
        return rl_fail(error, RL_ERR_CHECK, "the reference did not converge at N = %g %g %g", N.x, N.y, N.z);
    return RL_OK;
}

static int add_highlights(struct rl_record *r, const double *profile, const double *orthonormal, size_t n,
                          double room, struct rl_error *error)
{
    double low = INFINITY, high = -INFINITY, squares = 0.0, largest = 0.0, sum = 0.0;
    for (size_t i = 0; i < n; i++) {
        double d = profile[2 * i + 1];
        low = fmin(low, orthonormal[i]);
        high = fmax(high, orthonormal[i]);
        squares += d * d / (double)n;
        sum += d / (double)n;
        largest = fmax(largest, fabs(d));
    }
    double rms = sqrt(squares), both = 2.0 * room;
    const struct {
        const char *name;
        struct rl_interval x;
    } row[] = {
        {"orthonormal", {0.5 * (low + high), low - room, high + room}},
        {"spread", {high - low, fmax(high - low - both, 0.0), high - low + both}},
        {"rms", {rms, fmax(rms - both, 0.0), rms + both}},
        {"max", {largest, fmax(largest - both, 0.0), largest + both}},
        {"mean", {sum, sum - both, sum + both}},
    };
    int status = RL_OK;
    for (size_t i = 0; i < sizeof row / sizeof row[0] && status == RL_OK; i++)
        status = rl_record_add(r, row[i].name, row[i].x, "1", error);
    return status == RL_OK ? rl_record_series_add(r, "profile", profile, 2 * n, error) : status;
}

static int measure_light(struct rl_record *r, size_t points, struct rl_spent *spent, struct rl_error *error)
{
    struct rl_ellipsoid e = rl_ellipsoid_make(rl_parameter_number(r->parameters, "rr"));
    double beside = rl_parameter_number(r->parameters, "beside_rad");
    double tolerance = rl_parameter_number(r->parameters, "tolerance");
    double *profile = malloc(3 * points * sizeof *profile), room = 0.0;
    if (!profile)
        return rl_fail_memory(error, "a profile");
    double *orthonormal = profile + 2 * points;
    enum rl_spent_kind outer = rl_spent_on(spent, RL_SPENT_REFERENCE);
    int status = RL_OK;
    for (size_t i = 0; i < points && status == RL_OK; i++) {
        rl_vec3 N = sphere_point(i, points);
        double value[2] = {0.0, 0.0};
        status = highlights(value, &room, &e, N, beside, tolerance, error);
        orthonormal[i] = value[0];
        profile[2 * i] = fabs(N.x);
        profile[2 * i + 1] = value[1] - value[0];
    }
    rl_spent_on(spent, outer);
    if (status == RL_OK)
        status = add_highlights(r, profile, orthonormal, points, room, error);
    free(profile);
    return status;
}

/* Whole pictures: the reference with frame=printed, held against the reference. */
static int copy_image(struct rl_image *copy, const struct rl_image *image, struct rl_error *error)
{
    int status = rl_image_allocate(copy, image->width, image->height, image->channels, error);
    if (status == RL_OK)
        memcpy(copy->data, image->data,
               (size_t)image->width * (size_t)image->height * (size_t)image->channels * sizeof *image->data);
    return status;
}

/* Of the foreground's pixels, how many change by more than a step of an 8-bit frame buffer. */
static int moved_share(double *share, const struct rl_image *printed, const struct rl_image *truth,
                       const struct rl_metrics *m, struct rl_error *error)
{
    struct rl_image difference = {0};
    int status = rl_error_image(&difference, printed, truth, error);
    size_t moved = 0, n = (size_t)truth->width * (size_t)truth->height;
    for (size_t i = 0; i < n && status == RL_OK; i++)
        moved += fabsf(difference.data[i]) > (float)step_of_8_bits;
    *share = (double)moved / (double)m->pixels;
    rl_image_clear(&difference);
    return status;
}

static int measure_scene(struct rl_record *r, struct rl_bench *bench, const struct rl_scene *scene,
                         struct rl_error *error)
{
    char parameters[RL_PARAMETERS_MAX];
    const struct rl_image *image;
    struct rl_image printed = {0};
    snprintf(parameters, sizeof parameters, "%.300s method=reference frame=printed", r->parameters);
    int status = rl_bench_reference(&image, bench, scene, parameters, RL_LIGHT_FROM_POINT, error);
    if (status == RL_OK)
        status = copy_image(&printed, image, error);
    if (status == RL_OK)
        status = rl_bench_reference(&image, bench, scene, r->parameters, RL_LIGHT_FROM_POINT, error);
    struct rl_metrics m = {0};
    double share = 0.0;
    if (status == RL_OK)
        status = rl_metrics_compute(&m, &printed, image, error);
    if (status == RL_OK)
        status = moved_share(&share, &printed, image, &m, error);
    rl_image_clear(&printed);
    /* Each reference is within the tolerance everywhere. */
    double room = 2.0 * rl_parameter_number(r->parameters, "tolerance");
    if (status == RL_OK)
        status = rl_record_add(
            r, "rmse", (struct rl_interval){m.rmse, fmax(m.rmse - room, 0.0), m.rmse + room}, "1", error);
    if (status == RL_OK)
        status = rl_record_add(r, "max", (struct rl_interval){m.max, fmax(m.max - room, 0.0), m.max + room},
                               "1", error);
    if (status == RL_OK)
        status =
            rl_record_add(r, "mean", (struct rl_interval){m.bias, m.bias - room, m.bias + room}, "1", error);
    if (status == RL_OK)
        status = rl_record_add_exact(r, "moved", share, "1", error);
    return status;
}

int rl_frame_measure(struct rl_record *records, size_t n, struct rl_bench *bench,
                     const struct rl_scene *scene, struct rl_error *error)
{
    int status = RL_OK;
    for (size_t i = 0; i < n && status == RL_OK; i++) {
        struct rl_record *r = &records[i];
        if (scene) {
            status = measure_scene(r, bench, scene, error);
            continue;
        }
        double points = rl_parameter_number(r->parameters, "points");
        if (!(points >= 2.0 && points <= POINTS_MAX))
            return rl_fail(error, RL_ERR_INPUT, "points=%g: expected 2 to %d", points, POINTS_MAX);
        bool lobe = rl_parameters_match(r->parameters, "series=lobe");
        status = (lobe ? measure_lobe : measure_light)(r, (size_t)points, &bench->spent, error);
    }
    return status;
}
