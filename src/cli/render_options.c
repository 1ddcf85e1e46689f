/* From words to render settings (see render_options.h). */
#include "cli/render_options.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/method.h"
#include "model/ellipsoid.h"

const struct rl_option rl_options_render[] = {
    {'m', "method", "NAME",
     "highlight method of every material: plain, regular, random, exhaustive, reference (the scene's)"},
    {'n', "samples", "N", "normals a pixel, 1 to 1024 (regular 13, random 4)"},
    {0, "rr", "R", "R_r of every material, > 0; 1 is the roughest the paper allows (the scene's)"},
    {0, "interpolation", "NAME",
     "of the effects of every material: phong (normals), gouraud (radiance), constant (the scene's)"},
    {0, "attenuation", "on|off", "geometric attenuation G; off: G = 1 (on)"},
    {0, "frame", "NAME", "tangent frame: orthonormal, printed (orthonormal)"},
    {0, "normal-bits", "B", "bits a component of the normal map: 4 to 16, half, float (8)"},
    {0, "normal-size", "S", "texels along an edge of the normal map, a power of two, 64 to 2048 (512)"},
    {0, "env-size", "S", "texels along an edge of a face of the environment map, 8 to 4096 (256)"},
    {0, "env-format", "F", "rgba8, rgb10a2, r11g11b10f, rgba16, rgba16f, rgba32f (rgba8)"},
    {0, "margin", "M|off|auto[:B]",
     "bounding-sphere stencil: sphere radius = (1 + M) x the light's (off); auto: as large as keeps what a "
     "pixel "
     "loses within B of the brightest light's radiance (0.02)"},
    {0, "size", "WxH", "pixels (the scene's film)"},
    {0, "seed", "S", "seed of the baked random numbers (1)"},
    {0, "light-from", "WHERE",
     "reference: lights seen from each point, or from the object's centre as a map does: point, object "
     "(point)"},
    {0, "drop", "on|off",
     "leave out what cannot change a pixel: lights behind every surface, objects out of view (on)"},
    {0, "shadows", "on|off",
     "objects hide lights from one another, in highlights and effects; on the CPU (off)"},
    {0, "culling", "on|off", "do not draw back faces; off: surfaces show their backs too (on)"},
    {0, "depth-bits", "B", "of the GPU's depth buffer: 16, 24, 32 (float) (24)"},
    {0, "reversed-depth", "on|off",
     "the GPU's depth falls from 1 at the near plane to 0 at the far one (off)"},
    {0, "tolerance", "T", "reference: error wanted, relative to the brightest light (1e-5)"},
    {0},
};

const struct rl_option rl_options_machine[] = {
    {0, "backend", "NAME", "auto, osmesa, egl, egl-surfaceless, egl-device ($ROUGHLIGHT_BACKEND, auto)"},
    {0, "threads", "N", "of the CPU renderer and of Mesa's llvmpipe ($ROUGHLIGHT_THREADS, all)"},
    {0},
};

/* A whole number of pixels at *text, which moves behind it; 0 if there is none. */
static int scan_pixels(const char **text)
{
    char *end = NULL;
    long n = isdigit((unsigned char)**text) ? strtol(*text, &end, 10) : 0;
    if (n < 1 || n > RL_FILM_MAX)
        return 0;
    *text = end;
    return (int)n;
}

static int take_size(struct rl_settings *settings, const char *text, struct rl_error *error)
{
    const char *rest = text;
    settings->width = scan_pixels(&rest);
    bool separated = *rest == 'x';
    rest += separated;
    settings->height = scan_pixels(&rest);
    if (settings->width > 0 && separated && settings->height > 0 && *rest == '\0')
        return RL_OK;
    return rl_fail(error, RL_ERR_INPUT, "--size: found '%s', expected WIDTHxHEIGHT, each 1 to %d", text,
                   RL_FILM_MAX);
}

static int take_method(struct rl_settings *settings, const char *name, struct rl_error *error)
{
    const struct rl_method *method = rl_method_find(name);
    if (!method) {
        char names[256] = "";
        for (size_t i = 0, used = 0; i < rl_n_methods && used < sizeof names; i++)
            used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", i ? ", " : "",
                                     rl_methods[i]->name);
        return rl_fail(error, RL_ERR_INPUT, "--method: found '%s', expected one of %s", name, names);
    }
    settings->method = method->name;
    return RL_OK;
}

static int take_switch(bool *on, const char *text, const char *name, struct rl_error *error)
{
    *on = strcmp(text, "on") == 0;
    if (!*on && strcmp(text, "off") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--%s: found '%s', expected on or off", name, text);
    return RL_OK;
}

static int take_light_from(struct rl_settings *settings, const char *text, struct rl_error *error)
{
    settings->light_from = strcmp(text, "object") == 0 ? RL_LIGHT_FROM_OBJECT : RL_LIGHT_FROM_POINT;
    if (settings->light_from == RL_LIGHT_FROM_POINT && strcmp(text, "point") != 0)
        return rl_fail(error, RL_ERR_INPUT, "--light-from: found '%s', expected point or object", text);
    return RL_OK;
}

static int take_seed(struct rl_settings *settings, const char *text, struct rl_error *error)
{
    char *end = NULL;
    errno = 0;
    settings->seed = strtoull(text, &end, 10);
    if (text[0] < '0' || text[0] > '9' || *end != '\0' || errno != 0)
        return rl_fail(error, RL_ERR_INPUT, "--seed: found '%s', expected a whole number from 0 to 2^64 - 1",
                       text);
    return RL_OK;
}

static int take_numbers(struct rl_settings *settings, const struct rl_arguments *a, struct rl_error *error)
{
    long long samples = settings->samples;
    long long normal_size = settings->normal_size;
    long long env_size = settings->env_size;
    long long depth_bits = settings->depth_bits;
    int status = rl_argument_integer(a, "samples", 1, RL_SAMPLES_MAX, &samples, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "normal-size", 64, 2048, &normal_size, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "env-size", 8, 4096, &env_size, error);
    if (status == RL_OK)
        status = rl_argument_integer(a, "depth-bits", 16, 32, &depth_bits, error);
    if (status == RL_OK)
        status = rl_argument_number(a, "rr", RL_RR_MIN, RL_RR_MAX, &settings->rr, error);
    if (status == RL_OK)
        status = rl_argument_number(a, "tolerance", 1e-12, 0.1, &settings->tolerance, error);
    settings->samples = (int)samples;
    settings->normal_size = (int)normal_size;
    settings->env_size = (int)env_size;
    settings->depth_bits = (int)depth_bits;
    return status;
}

int rl_argument_settings(struct rl_settings *s, const struct rl_arguments *a, struct rl_error *error)
{
    const char *text;
    int status = take_numbers(s, a, error);
    if (status == RL_OK && (text = rl_argument(a, "method")))
        status = take_method(s, text, error);
    if (status == RL_OK && (text = rl_argument(a, "interpolation")))
        status = rl_parse_interpolation(&s->interpolation, text, "--interpolation", error);
    if (status == RL_OK && (text = rl_argument(a, "size")))
        status = take_size(s, text, error);
    if (status == RL_OK && (text = rl_argument(a, "seed")))
        status = take_seed(s, text, error);
    if (status == RL_OK && (text = rl_argument(a, "attenuation")))
        status = take_switch(&s->attenuation, text, "attenuation", error);
    if (status == RL_OK && (text = rl_argument(a, "drop")))
        status = take_switch(&s->drop, text, "drop", error);
    if (status == RL_OK && (text = rl_argument(a, "shadows")))
        status = take_switch(&s->shadows, text, "shadows", error);
    if (status == RL_OK && (text = rl_argument(a, "culling")))
        status = take_switch(&s->culling, text, "culling", error);
    if (status == RL_OK && (text = rl_argument(a, "reversed-depth")))
        status = take_switch(&s->reversed_depth, text, "reversed-depth", error);
    if (status == RL_OK && (text = rl_argument(a, "light-from")))
        status = take_light_from(s, text, error);
    if (status == RL_OK && (text = rl_argument(a, "frame")))
        status = rl_parse_frame(&s->frame, text, "--frame", error);
    if (status == RL_OK && (text = rl_argument(a, "normal-bits")))
        status = rl_parse_normal_bits(&s->normal_bits, text, "--normal-bits", error);
    if (status == RL_OK && (text = rl_argument(a, "env-format")))
        status = rl_parse_texel_format(&s->env_format, text, "--env-format", error);
    if (status == RL_OK && (text = rl_argument(a, "margin")))
        status = rl_parse_margin(s, text, "--margin", error);
    return status == RL_OK ? rl_settings_check(s, error) : status;
}

/* ---- Options that some methods have no use for --------------------------------------------------------------------- */

static bool is_sampled(const struct rl_method *m)
{
    return m->sampled;
}

static bool is_baked(const struct rl_method *m)
{
    return m->needs_normal_map;
}

static bool is_mapped(const struct rl_method *m)
{
    return m->needs_environment;
}

/* On the CPU the environment map is of exact radiance, and no pass is bounded by a sphere. */
static bool is_drawn_from_a_map(const struct rl_method *m)
{
    return m->needs_environment && m->on_gpu;
}

static bool has_microfacets(const struct rl_method *m)
{
    return !m->shade;
}

bool rl_method_integrates(const struct rl_method *m)
{
    return m->on_cpu && !m->shade && !m->needs_environment;
}

/* Given to others they are refused, lest somebody trusts in them. */
static const struct {
    const char *name;
    bool (*used)(const struct rl_method *method);
} method_options[] = {
    {"samples", is_sampled},
    {"normal-bits", is_baked},
    {"normal-size", is_baked},
    {"seed", is_baked},
    {"env-size", is_mapped},
    {"env-format", is_drawn_from_a_map},
    {"margin", is_drawn_from_a_map},
    {"attenuation", has_microfacets},
    {"frame", has_microfacets},
    {"tolerance", rl_method_integrates},
    {"light-from", rl_method_integrates},
};

/* The methods that a scene's materials have, or the one that replaces them all; of these the i-th, or NULL. */
static const struct rl_method *method_at(const struct rl_scene *scene, const struct rl_settings *settings,
                                         size_t i)
{
    if (settings->method)
        return i == 0 ? rl_method_find(settings->method) : NULL;
    for (size_t k = 0; k < scene->n_materials; k++)
        if (scene->material[k].method && i-- == 0)
            return rl_method_find(scene->material[k].method);
    return NULL;
}

static int no_effect(const char *option, bool (*used)(const struct rl_method *method),
                     const struct rl_method *method, const struct rl_scene *scene, struct rl_error *error)
{
    char names[128] = "";
    for (size_t i = 0; i < rl_n_methods; i++) {
        size_t length = strlen(names);
        if (used(rl_methods[i]))
            snprintf(names + length, sizeof names - length, "%s%s", length ? ", " : "", rl_methods[i]->name);
    }
    if (!method)
        return rl_fail(error, RL_ERR_INPUT, "--%s has no effect: no material of %s has a highlight", option,
                       scene->path);
    return rl_fail(error, RL_ERR_INPUT, "--%s has no effect with the method %s; it is for %s", option,
                   method->name, names);
}

int rl_argument_check_effect(const struct rl_arguments *a, const struct rl_scene *scene,
                             const struct rl_settings *settings, struct rl_error *error)
{
    for (size_t i = 0; i < sizeof method_options / sizeof method_options[0]; i++) {
        const struct rl_method *method;
        bool used = false;
        for (size_t k = 0; (method = method_at(scene, settings, k)) && !used; k++)
            used = method_options[i].used(method);
        if (!used && rl_argument(a, method_options[i].name))
            return no_effect(method_options[i].name, method_options[i].used, method_at(scene, settings, 0),
                             scene, error);
    }
    return RL_OK;
}

/* ---- Where to render ------------------------------------------------------------------------------------------------ */

const char *rl_argument_backend(const struct rl_arguments *arguments)
{
    const char *given = rl_argument(arguments, "backend");
    return given ? given : rl_environment_backend();
}

const char *rl_environment_backend(void)
{
    const char *variable = getenv("ROUGHLIGHT_BACKEND");
    return variable && *variable ? variable : "auto";
}

static int take_threads(const struct rl_arguments *arguments, int *threads, struct rl_error *error)
{
    enum { THREADS_MAX = 1024 };
    long long n = 0;
    if (rl_argument(arguments, "threads")) {
        int status = rl_argument_integer(arguments, "threads", 1, THREADS_MAX, &n, error);
        *threads = (int)n;
        return status;
    }
    const char *variable = getenv("ROUGHLIGHT_THREADS");
    double x = 0.0;
    if (variable && *variable &&
        (!rl_text_number(variable, &x) || x < 1 || x > THREADS_MAX || x != (double)(int)x))
        return rl_fail(error, RL_ERR_INPUT,
                       "ROUGHLIGHT_THREADS: found '%s', expected a whole number from 1 to %d", variable,
                       THREADS_MAX);
    *threads = (int)x;
    return RL_OK;
}

int rl_argument_threads(const struct rl_arguments *arguments, int *threads, struct rl_error *error)
{
    int status = take_threads(arguments, threads, error);
    if (status != RL_OK || *threads == 0)
        return status;
    char text[16];
    snprintf(text, sizeof text, "%d", *threads);
    setenv("LP_NUM_THREADS", text, 0);
    return RL_OK;
}
