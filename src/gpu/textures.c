/* Bakes normal maps and patterns in double precision and uploads them; allocates cube maps. */
#include "gpu/textures.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "gpu/context.h"
#include "model/ellipsoid.h"

enum { HALF_MANTISSA = 10 }; /* explicit bits */

GLenum rl_texel_internal_format(enum rl_texel_format format)
{
    static const GLenum internal_format[RL_TEXEL_FORMATS] = {
        [RL_TEXEL_RGBA8] = GL_RGBA8,
        [RL_TEXEL_RGB10A2] = GL_RGB10_A2,
        [RL_TEXEL_R11G11B10F] = GL_R11F_G11F_B10F,
        [RL_TEXEL_RGBA16] = GL_RGBA16,
        [RL_TEXEL_RGBA16F] = GL_RGBA16F,
        [RL_TEXEL_RGBA32F] = GL_RGBA32F,
    };
    return internal_format[format];
}

float rl_texel_unit(enum rl_texel_format format, float radiance_scale)
{
    if (!(radiance_scale > 0.0f))
        return 1.0f;
    switch (format) {
    case RL_TEXEL_R11G11B10F:
    case RL_TEXEL_RGBA16F:
    case RL_TEXEL_RGBA32F: {
        int exponent = 0;
        (void)frexpf(radiance_scale, &exponent);
        return ldexpf(1.0f, exponent < FLT_MAX_EXP ? exponent : FLT_MAX_EXP - 1);
    }
    default:
        return radiance_scale;
    }
}

/* The nearest number of `bits` explicit bits of mantissa and five of exponent: halves and their relatives. */
static double nearest_small_float(double value, int bits)
{
    int exponent = 0;
    (void)frexp(value, &exponent);
    int step = (exponent > -14 ? exponent : -13) - 1 - bits;
    return ldexp(nearbyint(ldexp(value, -step)), step);
}

float rl_texel_nearest(enum rl_texel_format format, int component, double value)
{
    double levels = 0.0;
    switch (format) {
    case RL_TEXEL_R11G11B10F:
        return (float)nearest_small_float(value, component < 2 ? 6 : 5);
    case RL_TEXEL_RGBA16F:
        return (float)nearest_small_float(value, HALF_MANTISSA);
    case RL_TEXEL_RGBA8:
        levels = 255.0;
        break;
    case RL_TEXEL_RGB10A2:
        levels = 1023.0;
        break;
    case RL_TEXEL_RGBA16:
        levels = 65535.0;
        break;
    default:
        return (float)value;
    }
    /* A quarter of a step above the level is on the safe side of both. */
    return (float)fmin(1.0, (nearbyint(levels * value) + 0.25) / levels);
}

/* (v + 1)/2 in steps of 1/levels. */
static unsigned quantize(double v, unsigned levels)
{
    return (unsigned)lround((v + 1.0) / 2.0 * levels);
}

/* In steps of those bits, as a texel of 16 holds them: within half a step of its own. */
static unsigned quantize_16(double v, int bits)
{
    unsigned levels = (1u << bits) - 1;
    return (unsigned)lround((double)quantize(v, levels) * UINT16_MAX / levels);
}

/* Halves are rounded here, so that it does not matter how OpenGL does it. */
static float float_texel(double v, bool half)
{
    double stored = (v + 1.0) / 2.0;
    return (float)(half ? nearest_small_float(stored, HALF_MANTISSA) : stored);
}

double rl_normal_component(int bits, double v)
{
    switch (bits) {
    case RL_NORMAL_BITS_HALF:
    case RL_NORMAL_BITS_FLOAT:
        return 2.0 * (double)float_texel(v, bits == RL_NORMAL_BITS_HALF) - 1.0;
    case 8:
        return 2.0 * quantize(v, 255) / 255.0 - 1.0;
    case 10:
        return 2.0 * quantize(v, 1023) / 1023.0 - 1.0;
    default:
        return 2.0 * quantize_16(v, bits) / UINT16_MAX - 1.0;
    }
}

static void store_float(void *data, size_t i, struct rl_microfacet h, bool half)
{
    const double v[3] = {h.x, h.y, h.z};
    float *to = (float *)data + 4 * i;
    for (int c = 0; c < 3; c++)
        to[c] = float_texel(v[c], half);
    to[3] = 1.0f;
}

static void store_8(void *data, size_t i, struct rl_microfacet h)
{
    uint8_t *to = (uint8_t *)data + 4 * i;
    to[0] = (uint8_t)quantize(h.x, 255);
    to[1] = (uint8_t)quantize(h.y, 255);
    to[2] = (uint8_t)quantize(h.z, 255);
    to[3] = 255;
}

static void store_10(void *data, size_t i, struct rl_microfacet h)
{
    uint32_t *to = (uint32_t *)data + i;
    *to = quantize(h.x, 1023) | quantize(h.y, 1023) << 10 | quantize(h.z, 1023) << 20 | 3u << 30;
}

/* Any other number of bits. */
static void store_16(void *data, size_t i, struct rl_microfacet h, int bits)
{
    uint16_t *to = (uint16_t *)data + 4 * i;
    to[0] = (uint16_t)quantize_16(h.x, bits);
    to[1] = (uint16_t)quantize_16(h.y, bits);
    to[2] = (uint16_t)quantize_16(h.z, bits);
    to[3] = UINT16_MAX;
}

static void store(void *data, size_t i, struct rl_microfacet h, int bits)
{
    switch (bits) {
    case RL_NORMAL_BITS_HALF:
    case RL_NORMAL_BITS_FLOAT:
        store_float(data, i, h, bits == RL_NORMAL_BITS_HALF);
        break;
    case 8:
        store_8(data, i, h);
        break;
    case 10:
        store_10(data, i, h);
        break;
    default:
        store_16(data, i, h, bits);
    }
}

static struct rl_normal_texels layout(int bits)
{
    switch (bits) {
    case RL_NORMAL_BITS_HALF:
        return (struct rl_normal_texels){NULL, 16, GL_RGBA16F, GL_RGBA, GL_FLOAT};
    case RL_NORMAL_BITS_FLOAT:
        return (struct rl_normal_texels){NULL, 16, GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case 8:
        return (struct rl_normal_texels){NULL, 4, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case 10:
        return (struct rl_normal_texels){NULL, 4, GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV};
    default:
        return (struct rl_normal_texels){NULL, 8, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT};
    }
}

int rl_normal_texels_make(struct rl_normal_texels *texels, const struct rl_plan_normal_map *map,
                          const struct rl_settings *settings, struct rl_error *error)
{
    *texels = layout(settings->normal_bits);
    long count = (long)settings->normal_size * settings->normal_size;
    texels->bytes *= (size_t)count;
    texels->data = malloc(texels->bytes);
    if (!texels->data)
        return rl_fail_memory(error, "the normal map");
    struct rl_ellipsoid e = rl_ellipsoid_make(map->rr);
    void *data = texels->data;
    /* Every texel has random numbers of its own, so that threads change nothing. For a small map they do not pay: threads that wait for
     * more work spin for longer than it takes, at the expense of the renderer's. */
#pragma omp parallel for schedule(static) if (count > 1L << 14)
    for (long i = 0; i < count; i++)
        store(data, (size_t)i, map->method->texel(&e, settings->seed, (uint64_t)i), settings->normal_bits);
    return RL_OK;
}

/* No filter mixes normals or lights, and there are no smaller levels. */
static void use_single_texels(const struct rl_gl *gl, GLenum target, GLint wrap)
{
    gl->TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
    gl->TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
}

int rl_normal_map_make(GLuint *texture, struct rl_gl *gl, const struct rl_plan_normal_map *map,
                       const struct rl_settings *settings, size_t *bytes, struct rl_error *error)
{
    struct rl_normal_texels texels;
    int size = settings->normal_size;
    int status = rl_normal_texels_make(&texels, map, settings, error);
    if (status != RL_OK)
        return status;
    gl->GenTextures(1, texture);
    gl->BindTexture(GL_TEXTURE_2D, *texture);
    use_single_texels(gl, GL_TEXTURE_2D, GL_REPEAT);
    gl->TexStorage2D(GL_TEXTURE_2D, 1, texels.internal_format, size, size);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size, size, texels.format, texels.type, texels.data);
    free(texels.data);
    *bytes += texels.bytes;
    return rl_gl_check(gl, "the normal map", error);
}

/* Every format that a normal map may have can be attached to a frame buffer and read from there. */
static int read_texture(float **texels, struct rl_gl *gl, GLuint texture, int size, struct rl_error *error)
{
    GLuint framebuffer;
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    int status = RL_OK;
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        status = rl_fail(error, RL_ERR_UNAVAILABLE, "this OpenGL cannot read the normal map's format back");
    *texels = malloc((size_t)size * (size_t)size * 4 * sizeof **texels);
    if (status == RL_OK && !*texels)
        status = rl_fail_memory(error, "the normal map");
    if (status == RL_OK) {
        gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl->ReadPixels(0, 0, size, size, GL_RGBA, GL_FLOAT, *texels);
        status = rl_gl_check(gl, "reading the normal map", error);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->DeleteFramebuffers(1, &framebuffer);
    return status;
}

int rl_gpu_normal_map_read(float **texels, struct rl_gpu *gpu, const struct rl_plan_normal_map *map,
                           const struct rl_settings *settings, struct rl_error *error)
{
    GLuint texture = 0;
    size_t bytes = 0;
    *texels = NULL;
    int status = rl_normal_map_make(&texture, &gpu->gl, map, settings, &bytes, error);
    if (status == RL_OK)
        status = read_texture(texels, &gpu->gl, texture, settings->normal_size, error);
    gpu->gl.DeleteTextures(1, &texture);
    if (status != RL_OK) {
        free(*texels);
        *texels = NULL;
    }
    return status;
}

int rl_pattern_make(GLuint *buffer, struct rl_gl *gl, const struct rl_plan_pattern *pattern, size_t *bytes,
                    struct rl_error *error)
{
    struct rl_microfacet microfacet[RL_SAMPLES_MAX];
    float data[RL_SAMPLES_MAX][4];
    struct rl_ellipsoid e = rl_ellipsoid_make(pattern->rr);
    pattern->method->pattern(&e, pattern->samples, microfacet);
    for (int i = 0; i < pattern->samples; i++) {
        data[i][0] = (float)microfacet[i].x;
        data[i][1] = (float)microfacet[i].y;
        data[i][2] = (float)microfacet[i].z;
        data[i][3] = (float)microfacet[i].weight;
    }
    size_t size = (size_t)pattern->samples * sizeof data[0];
    gl->GenBuffers(1, buffer);
    gl->BindBuffer(GL_UNIFORM_BUFFER, *buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, data, GL_STATIC_DRAW);
    *bytes += size;
    return rl_gl_check(gl, "the pattern", error);
}

int rl_cube_make(GLuint *texture, struct rl_gl *gl, const struct rl_settings *settings,
                 struct rl_error *error)
{
    GLint largest = 0;
    gl->GetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &largest);
    if (settings->env_size > largest)
        return rl_fail(error, RL_ERR_UNAVAILABLE,
                       "environment map of %d texels an edge: this OpenGL allows up to %d",
                       settings->env_size, (int)largest);
    gl->GenTextures(1, texture);
    gl->BindTexture(GL_TEXTURE_CUBE_MAP, *texture);
    use_single_texels(gl, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
    gl->TexStorage2D(GL_TEXTURE_CUBE_MAP, 1, rl_texel_internal_format(settings->env_format),
                     settings->env_size, settings->env_size);
    char what[64];
    snprintf(what, sizeof what, "an environment map of 6 x %d x %d texels", settings->env_size,
             settings->env_size);
    return rl_gl_check(gl, what, error);
}
