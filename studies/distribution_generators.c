/* Where the random numbers of a pixel come from, on a small model: a plane at N = (0, 0, 1), a far eye, and a square light whose
 * mirror image has its edge near the plane's origin. The same estimate (1/N) sum of G L_e, on the light itself, by three generators:
 *
 *     lcg     a linear congruential generator that starts anew at every pixel, as a shader of Kimura and Tokoi's time would have it:
 *             a pixel has no memory of the one before. x -> 1664525 x + 1013904223 modulo 2^32 (Press, Teukolsky, Vetterling, Flannery:
 *             Numerical Recipes in C, 2nd edition, 1992, section 7.1, "ranqd1")
 *     baked   the paper's: texels of a normal map, as the GPU has them and by the pixel's own address, as the shader reads them
 *     hash    an integer hash of pixel, sample and seed, as one would do today: pcg4d (Jarzynski and Olano: Hash Functions for GPU
 *             Rendering, JCGT 9 (3), 2020)
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gpu/program.h"
#include "measure/statistics.h"
#include "model/attenuation.h"
#include "model/frame.h"
#include "model/random.h"
#include "reference/integrator.h"
#include "studies/distribution.h"

enum { SEEDS_MAX = 64, SIZE_MAX_PX = 256, CORNERS = 4 };

/* The mirror direction misses the light by little: where noise is largest. Exactly on the edge it would be a special place. */
static const rl_vec3 light[CORNERS] = {
    {-1.02, -0.5, 2.0}, {-1.02, 0.5, 2.0}, {-2.02, 0.5, 2.0}, {-2.02, -0.5, 2.0}};
/* V: 26.6 degrees off N; the mirror direction is (-1, 0, 2)/sqrt(5). */
static const rl_vec3 towards_eye = {0.4472135954999579, 0.0, 0.8944271909999159};

enum generator { LCG, BAKED, HASH };

struct model {
    enum generator generator;
    struct rl_ellipsoid e;
    int samples, size; /* of a pixel; pixels along an edge */
    double step;       /* between pixels on the plane; 0: all see one point */
    uint64_t seed;
    const float *texels; /* BAKED: four a texel */
    unsigned map_size, map_step;
};

/* A patch has the light's mirror image in its middle. */
static const double image_x = -0.52;

static rl_vec3 point_at(const struct model *m, int x, int y)
{
    double middle = 0.5 * (m->size - 1), start = m->step > 0.0 ? image_x : 0.0;
    return v3(start + (x - middle) * m->step, (y - middle) * m->step, 0.0);
}

/* Whether the ray from P along L meets the light: L is inside the cone if it lies on the same side of every edge's plane. */
static bool sees_light(rl_vec3 P, rl_vec3 L)
{
    int inside = 0;
    for (int i = 0; i < CORNERS; i++) {
        rl_vec3 a = v3_sub(light[i], P), b = v3_sub(light[(i + 1) % CORNERS], P);
        inside += v3_dot(v3_cross(a, b), L) > 0.0;
    }
    return inside == CORNERS && L.z > 0.0;
}

/* G L_e of a microfacet normal, in the shader's way: H need not have unit length. */
static double radiance(rl_vec3 P, rl_vec3 H)
{
    H = v3_normalize(H);
    double v_h = v3_dot(towards_eye, H);
    rl_vec3 L = v3_reflect(towards_eye, H);
    return sees_light(P, L) ? rl_attenuation(H.z, towards_eye.z, L.z, v_h) : 0.0;
}

static rl_vec3 drawn_normal(const struct model *m, double u, double v)
{
    static const rl_vec3 N = {0.0, 0.0, 1.0};
    struct rl_frame frame = rl_frame_make(RL_FRAME_ORTHONORMAL, N);
    struct rl_delta d = rl_ellipsoid_inverse(&m->e, u);
    return rl_frame_microfacet_normal(&frame, d.sin_delta, d.cos_delta, RL_PI * v);
}

static double unit(uint32_t bits)
{
    return (bits + 0.5) * 0x1p-32;
}

static uint32_t lcg_next(uint32_t x)
{
    return x * UINT32_C(1664525) + UINT32_C(1013904223);
}

/* Two numbers for sample i of pixel (x, y). */
static void pcg4d(double out[2], uint32_t x, uint32_t y, uint32_t i, uint32_t seed)
{
    uint32_t v[4] = {x, y, i, seed};
    for (int c = 0; c < 4; c++)
        v[c] = lcg_next(v[c]);
    for (int round = 0; round < 2; round++) {
        v[0] += v[1] * v[3];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
        v[3] += v[1] * v[2];
        for (int c = 0; c < 4 && round == 0; c++)
            v[c] ^= v[c] >> 16;
    }
    out[0] = unit(v[0]);
    out[1] = unit(v[1]);
}

/* The texel of shaders/common/normal_map.glsl. */
static rl_vec3 baked_normal(const struct model *m, unsigned x, unsigned y, unsigned i)
{
    unsigned mask = m->map_size - 1, at = (i * m->map_step) & (m->map_size * m->map_size - 1);
    size_t column = (x + (at & mask)) & mask, row = (y + at / m->map_size) & mask;
    const float *t = m->texels + 4 * (row * m->map_size + column);
    /* The map's normals are about x; y and z go to the frame's T and B, which here are x and y. */
    return v3(2.0f * t[1] - 1.0f, 2.0f * t[2] - 1.0f, 2.0f * t[0] - 1.0f);
}

static double pixel(const struct model *m, int x, int y)
{
    rl_vec3 P = point_at(m, x, y);
    uint32_t state = (uint32_t)rl_random_bits(m->seed, 0); /* lcg: the same at every pixel */
    double sum = 0.0;
    for (unsigned i = 0; i < (unsigned)m->samples; i++) {
        double u[2];
        if (m->generator == BAKED) {
            sum += radiance(P, baked_normal(m, (unsigned)x, (unsigned)y, i));
            continue;
        }
        if (m->generator == LCG)
            for (int c = 0; c < 2; c++) {
                state = lcg_next(state);
                u[c] = unit(state);
            }
        else
            pcg4d(u, (uint32_t)x, (uint32_t)y, i, (uint32_t)m->seed);
        sum += radiance(P, drawn_normal(m, u[0], u[1]));
    }
    return sum / m->samples;
}

/* The reference at P. */
static int integrate(struct rl_estimate *truth, const struct model *m, rl_vec3 P, struct rl_error *error)
{
    const rl_vec3 *const polygon[] = {light};
    const size_t corners[] = {CORNERS};
    struct rl_light_set *set;
    int status = rl_light_set_from_polygons(&set, polygon, corners, 1, error);
    if (status != RL_OK)
        return status;
    const struct rl_integrate_options options = {
        .attenuation = true, .tolerance = 1e-8, .simd = rl_simd_best()};
    const struct rl_surface surface = {P, {0.0, 0.0, 1.0}, towards_eye};
    rl_integrate_lines(truth, &surface, &m->e, set, &options);
    rl_light_set_free(set);
    return truth->converged ? RL_OK : rl_fail(error, RL_ERR_CHECK, "the reference did not converge");
}

/* What a case's parameters say; the map is baked for each seed. */
static int make_model(struct model *m, struct rl_settings *settings, const struct rl_record *r,
                      struct rl_error *error)
{
    char name[RL_NAME_MAX];
    int status = rl_bench_settings(settings, r->parameters, error);
    if (status != RL_OK)
        return status;
    rl_parameter(r->parameters, "generator", name, sizeof name);
    double size = rl_parameter_number(r->parameters, "size"),
           step = rl_parameter_number(r->parameters, "step");
    if (!(size >= 2.0 && size <= SIZE_MAX_PX) || !(step >= 0.0))
        return rl_fail(error, RL_ERR_INPUT, "size=%g step=%g: expected 2 to %d pixels, a step from 0", size,
                       step, SIZE_MAX_PX);
    *m = (struct model){.generator = strcmp(name, "lcg") == 0    ? LCG
                                     : strcmp(name, "hash") == 0 ? HASH
                                                                 : BAKED,
                        .e = rl_ellipsoid_make(settings->rr),
                        .samples = settings->samples,
                        .size = (int)size,
                        .step = step,
                        .map_size = (unsigned)settings->normal_size,
                        .map_step = rl_normal_map_step(settings->normal_size)};
    return RL_OK;
}

/* All pixels of one seed. */
static int draw(double *value, struct model *m, struct rl_settings *settings, uint64_t seed,
                struct rl_bench *bench, struct rl_error *error)
{
    float *texels = NULL;
    int status = RL_OK;
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    m->seed = settings->seed = seed;
    if (m->generator == BAKED) {
        const struct rl_plan_normal_map map = {.rr = settings->rr, .method = rl_method_find("random")};
        status = rl_gpu_normal_map_read(&texels, bench->gpu, &map, settings, error);
    }
    m->texels = texels;
    for (int i = 0; i < m->size * m->size && status == RL_OK; i++)
        value[i] = pixel(m, i % m->size, i / m->size);
    free(texels);
    m->texels = NULL;
    rl_spent_on(&bench->spent, outer);
    return status;
}

static struct rl_interval root(struct rl_interval x)
{
    return (struct rl_interval){sqrt(fmax(x.value, 0.0)), sqrt(fmax(x.low, 0.0)), sqrt(fmax(x.high, 0.0))};
}

/* The error of each seed's pixels, taken apart. */
struct parts {
    double bias[SEEDS_MAX], bias2[SEEDS_MAX], variance[SEEDS_MAX], share[SEEDS_MAX];
};

/* The square of the mean error has the mean's own noise in it, variance/n, which is taken out of bias2. */
static void split(struct parts *parts, size_t seed, const double *value, size_t n, double truth)
{
    double mean = 0.0, squares = 0.0;
    for (size_t i = 0; i < n; i++)
        mean += value[i] / (double)n;
    for (size_t i = 0; i < n; i++)
        squares += (value[i] - mean) * (value[i] - mean);
    double bias = mean - truth;
    parts->bias[seed] = bias;
    parts->variance[seed] = squares / ((double)n - 1.0);
    parts->bias2[seed] = bias * bias - parts->variance[seed] / (double)n;
    parts->share[seed] = bias * bias / (bias * bias + squares / (double)n);
}

static int add_parts(struct rl_record *r, const struct parts *p, size_t n, const struct rl_estimate *truth,
                     struct rl_error *error)
{
    double t = truth->value[0], room = truth->error[0];
    const struct rl_interval b = rl_mean_interval(p->bias2, n, 0.95);
    const struct rl_interval v = rl_mean_interval(p->variance, n, 0.95);
    const struct {
        const char *name;
        struct rl_interval x;
    } row[] = {
        {"truth", {t, t - room, t + room}},
        {"bias", rl_mean_interval(p->bias, n, 0.95)},
        {"bias2", b},
        {"bias_share", rl_mean_interval(p->share, n, 0.95)},
        {"variance", v},
        {"floor", root(b)},
        {"noise", root(v)},
    };
    int status = RL_OK;
    for (size_t i = 0; i < sizeof row / sizeof row[0] && status == RL_OK; i++)
        status = rl_record_add(r, row[i].name, row[i].x, "1", error);
    return status;
}

static int measure_point(struct rl_record *r, struct model *m, struct rl_settings *settings, double *value,
                         struct rl_bench *bench, struct rl_error *error)
{
    struct parts parts;
    double seeds = rl_parameter_number(r->parameters, "seeds");
    if (!(seeds >= 2.0 && seeds <= SEEDS_MAX))
        return rl_fail(error, RL_ERR_INPUT, "seeds=%g: expected 2 to %d", seeds, SEEDS_MAX);
    double first = rl_parameter_number(r->parameters, "seed");
    struct rl_estimate truth = {0};
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
    int status = integrate(&truth, m, v3(0.0, 0.0, 0.0), error);
    rl_spent_on(&bench->spent, outer);
    size_t n = (size_t)seeds;
    for (size_t k = 0; k < n && status == RL_OK; k++) {
        status = draw(value, m, settings, k + (isnan(first) ? 1 : (uint64_t)first), bench, error);
        if (status == RL_OK)
            split(&parts, k, value, (size_t)m->size * (size_t)m->size, truth.value[0]);
    }
    return status == RL_OK ? add_parts(r, &parts, n, &truth, error) : status;
}

/* The pixels themselves; generator=reference: the truth at each. */
static int measure_patch(struct rl_record *r, struct model *m, struct rl_settings *settings, double *value,
                         struct rl_bench *bench, struct rl_error *error)
{
    size_t n = (size_t)m->size * (size_t)m->size;
    int status = RL_OK;
    if (rl_parameters_match(r->parameters, "generator=reference")) {
        struct rl_estimate truth = {0};
        enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_REFERENCE);
        for (int i = 0; i < (int)n && status == RL_OK; i++) {
            status = integrate(&truth, m, point_at(m, i % m->size, i / m->size), error);
            value[i] = truth.value[0];
        }
        rl_spent_on(&bench->spent, outer);
    } else {
        status = draw(value, m, settings, 1, bench, error);
    }
    return status == RL_OK ? rl_record_series_add(r, "picture", value, n, error) : status;
}

int rl_distribution_measure_generator(struct rl_record *r, struct rl_bench *bench, struct rl_error *error)
{
    struct model m;
    struct rl_settings settings;
    int status = make_model(&m, &settings, r, error);
    if (status != RL_OK)
        return status;
    double *value = malloc((size_t)m.size * (size_t)m.size * sizeof *value);
    if (!value)
        return rl_fail_memory(error, "a picture");
    bool patch = rl_parameters_match(r->parameters, "series=patch");
    status = (patch ? measure_patch : measure_point)(r, &m, &settings, value, bench, error);
    free(value);
    return status;
}
