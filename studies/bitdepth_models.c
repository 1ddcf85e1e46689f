/* What has no texture to be coarse in: the regular method's pattern, which the shader gets as floats, and the frame buffer, which
 * the pipeline keeps in floats. Both are rounded here, before the one is uploaded and after the other is read (see bitdepth.h). */
#include <math.h>
#include <string.h>

#include "gpu/textures.h"
#include "studies/bitdepth.h"

static void round_pattern(struct rl_microfacet *m, int n, int bits)
{
    for (int i = 0; i < n; i++) {
        m[i].x = rl_normal_component(bits, m[i].x);
        m[i].y = rl_normal_component(bits, m[i].y);
        m[i].z = rl_normal_component(bits, m[i].z);
    }
}

/* A method's pattern has no argument for the bits: one function each. */
#define BITS(ROW)                                                                                            \
    ROW(four, 4)                                                                                             \
    ROW(five, 5)                                                                                             \
    ROW(six, 6)                                                                                              \
    ROW(eight, 8)                                                                                            \
    ROW(ten, 10)                                                                                             \
    ROW(twelve, 12)                                                                                          \
    ROW(sixteen, 16)                                                                                         \
    ROW(half, RL_NORMAL_BITS_HALF)                                                                           \
    ROW(float32, RL_NORMAL_BITS_FLOAT)

#define DEFINE(name, bits)                                                                                   \
    static void pattern_##name(const struct rl_ellipsoid *e, int n, struct rl_microfacet *m)                 \
    {                                                                                                        \
        rl_method_find("regular")->pattern(e, n, m);                                                         \
        round_pattern(m, n, bits);                                                                           \
    }
BITS(DEFINE)

static int rounded_regular(struct rl_method *method, int bits, struct rl_error *error)
{
#define ENTRY(name, bits) {bits, pattern_##name},
    static const struct {
        int bits;
        void (*pattern)(const struct rl_ellipsoid *, int, struct rl_microfacet *);
    } table[] = {BITS(ENTRY)};
    *method = *rl_method_find("regular");
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (table[i].bits == bits) {
            method->pattern = table[i].pattern;
            return RL_OK;
        }
    return rl_fail(error, RL_ERR_INPUT, "normal_bits: a regular pattern is not rounded to these bits");
}

int rl_bitdepth_pattern_picture(struct rl_image *image, struct rl_bench *bench, const struct rl_scene *scene,
                                const char *parameters, struct rl_error *error)
{
    struct rl_settings settings;
    struct rl_method method;
    int status = rl_bench_settings(&settings, parameters, error);
    if (status == RL_OK)
        status = rounded_regular(&method, settings.normal_bits, error);
    struct rl_plan plan;
    if (status == RL_OK)
        status = rl_plan_make(&plan, scene, &settings, error);
    if (status != RL_OK)
        return status;
    for (size_t i = 0; i < plan.n_patterns; i++)
        plan.pattern[i].method = &method;
    enum rl_spent_kind outer = rl_spent_on(&bench->spent, RL_SPENT_SETUP);
    struct rl_gpu_scene *gs = NULL;
    double seconds = 0.0;
    status = rl_gpu_scene_make(&gs, bench->gpu, scene, &plan, error);
    if (status == RL_OK)
        status = rl_gpu_scene_warm_up(gs, error);
    rl_spent_on(&bench->spent, RL_SPENT_MEASURED);
    if (status == RL_OK)
        status = rl_gpu_scene_frame(gs, &seconds, error);
    if (status == RL_OK)
        status = rl_gpu_scene_read(gs, image, error);
    rl_spent_on(&bench->spent, RL_SPENT_SETUP);
    rl_gpu_scene_free(gs);
    rl_plan_clear(&plan);
    rl_spent_on(&bench->spent, outer);
    return status;
}

/* The largest value, and the steps up to it, of an unsigned format; 0: a floating-point one. */
static double levels(enum rl_texel_format format)
{
    switch (format) {
    case RL_TEXEL_RGBA8:
        return 255.0;
    case RL_TEXEL_RGB10A2:
        return 1023.0;
    case RL_TEXEL_RGBA16:
        return 65535.0;
    default:
        return 0.0;
    }
}

static float round_value(enum rl_texel_format format, int component, double value)
{
    double n = levels(format);
    return n > 0.0 ? (float)(nearbyint(n * fmin(fmax(value, 0.0), 1.0)) / n)
                   : rl_texel_nearest(format, component, value);
}

/* One picture; returns how many values of the foreground were cut off. */
static size_t round_picture(struct rl_image *rounded, struct rl_image *clamped, const struct rl_image *exact,
                            const struct rl_image *surface, enum rl_texel_format format)
{
    size_t n = (size_t)exact->width * (size_t)exact->height * 4, cut = 0;
    memcpy(rounded->data, exact->data, n * sizeof *exact->data);
    memcpy(clamped->data, exact->data, n * sizeof *exact->data);
    for (size_t i = 0; i < n; i++) {
        int c = (int)(i % 4);
        if (c == 3)
            continue;
        double highlight = (double)exact->data[i] - (double)surface->data[i];
        rounded->data[i] = round_value(format, c, round_value(format, c, surface->data[i]) + highlight);
        if (levels(format) > 0.0 && exact->data[i] > 1.0f) {
            clamped->data[i] = 1.0f;
            cut += exact->data[i - (size_t)c + 3] >= 0.5f;
        }
    }
    return cut;
}

int rl_bitdepth_frames(struct rl_seeds *rounded, struct rl_seeds *clamped, double *share,
                       const struct rl_seeds *exact, const struct rl_image *surface,
                       enum rl_texel_format format, struct rl_error *error)
{
    size_t cut = 0, values = 0;
    for (size_t k = 0; k < exact->n; k++) {
        const struct rl_image *e = &exact->image[k];
        int status = rl_image_allocate(&rounded->image[rounded->n++], e->width, e->height, 4, error);
        if (status == RL_OK)
            status = rl_image_allocate(&clamped->image[clamped->n++], e->width, e->height, 4, error);
        if (status != RL_OK)
            return status;
        cut += round_picture(&rounded->image[k], &clamped->image[k], e, surface, format);
        for (int i = 0; i < e->width * e->height; i++)
            values += e->data[4 * i + 3] >= 0.5f ? 3 : 0;
    }
    *share = values ? (double)cut / (double)values : 0.0;
    return RL_OK;
}
