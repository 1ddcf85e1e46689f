/* How to render: the knobs that studies turn. A scene file may set defaults; options of the command line
 * win. */
#ifndef RL_SCENE_SETTINGS_H
#define RL_SCENE_SETTINGS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "model/frame.h"
#include "model/material.h"

/* Texels of the environment map. In the unsigned normalised ones (8, 10 and 16 bits) radiance is divided
 * by the brightest light's, so that nothing clips. */
enum rl_texel_format {
    RL_TEXEL_RGBA8,
    RL_TEXEL_RGB10A2,
    RL_TEXEL_R11G11B10F,
    RL_TEXEL_RGBA16,
    RL_TEXEL_RGBA16F,
    RL_TEXEL_RGBA32F,
    RL_TEXEL_FORMATS
};

/* Bits per component of the normal map: 4 to 16 unsigned normalised, or these. */
enum { RL_NORMAL_BITS_HALF = -16, RL_NORMAL_BITS_FLOAT = -32 };

#define RL_MARGIN_MAX 1e6

/* What `margin auto` lets a pixel lose of its highlight, in parts of the brightest light's radiance (scene/margin.h). */
#define RL_MARGIN_BOUND 0.02
#define RL_MARGIN_BOUND_MIN 1e-6
#define RL_MARGIN_BOUND_MAX 0.999

enum { RL_FILM_MAX = 16384 }; /* pixels along either side */

enum rl_margin { RL_MARGIN_OFF, RL_MARGIN_AUTO, RL_MARGIN_VALUE };

/* Where the reference sees the lights from: each pixel's own point, or its object's centre as an
 * environment map does. The difference is the map's parallax error. */
enum rl_light_from { RL_LIGHT_FROM_POINT, RL_LIGHT_FROM_OBJECT };

/* No enum rl_interpolation, but what each material says. */
enum { RL_INTERPOLATION_OF_MATERIAL = -1 };

struct rl_settings {
    const char *method; /* overrides every material's; NULL: as the scene says */
    int interpolation;  /* overrides every material's; RL_INTERPOLATION_OF_MATERIAL: as the scene says */
    int samples;        /* 1 to 1024; 0: the method's default */
    double rr;          /* overrides every material's R_r; 0: as the scene says */
    int normal_bits;    /* 4..16, RL_NORMAL_BITS_HALF or RL_NORMAL_BITS_FLOAT */
    int normal_size;    /* texels along an edge of the normal map: a power of two, 64 to 2048 */
    int env_size;       /* texels along an edge of a cube face: 8 to 4096 */
    enum rl_texel_format env_format;
    enum rl_margin margin_kind;
    double margin;       /* RL_MARGIN_VALUE: sphere radius = (1 + margin) x the light's; 0 to RL_MARGIN_MAX */
    double margin_bound; /* RL_MARGIN_AUTO: RL_MARGIN_BOUND_MIN to RL_MARGIN_BOUND_MAX */
    int width, height;   /* pixels, 1 to 16384; 0: the scene's film */
    uint64_t seed;
    bool attenuation;
    bool drop; /* the plan leaves out what cannot change a pixel; false: for comparison */
    enum rl_frame_kind frame;
    /* Reference: largest absolute error wanted of L_o, relative to the brightest light; 1e-12 to 0.1. */
    double tolerance;
    enum rl_light_from light_from; /* reference */
    /* Back faces are not drawn; false: a surface shows its back too, shaded with -N. GPU and CPU alike. */
    bool culling;
    int depth_bits;      /* of the GPU's depth buffer: 16, 24 (both whole numbers) or 32 (float) */
    bool reversed_depth; /* the GPU's depth falls from 1 at the near plane to 0 at the far one */
    bool
        shadows; /* on the CPU: objects hide lights from one another, in highlights and effects; never from themselves */
};

/* The paper's: 8-bit normals, environment 256, attenuation on, margin off, orthonormal frame, no shadows,
 * back faces culled, 24 bits of depth;
 * seed 1; tolerance 1e-5. */
#define RL_SETTINGS_DEFAULT                                                                                  \
    ((struct rl_settings){.normal_bits = 8,                                                                  \
                          .normal_size = 512,                                                                \
                          .env_size = 256,                                                                   \
                          .env_format = RL_TEXEL_RGBA8,                                                      \
                          .margin_kind = RL_MARGIN_OFF,                                                      \
                          .margin_bound = RL_MARGIN_BOUND,                                                   \
                          .seed = 1,                                                                         \
                          .attenuation = true,                                                               \
                          .drop = true,                                                                      \
                          .frame = RL_FRAME_ORTHONORMAL,                                                     \
                          .culling = true,                                                                   \
                          .depth_bits = 24,                                                                  \
                          .interpolation = RL_INTERPOLATION_OF_MATERIAL,                                     \
                          .tolerance = 1e-5})

/* Checks every range; the message names the option in its command-line spelling, what was found and what
 * was expected. */
int rl_settings_check(const struct rl_settings *settings, struct rl_error *error);
/* The same for scene files, which name keys in their own way: *key is "normal-bits" and the like, the
 * message is without it. */
int rl_settings_check_key(const struct rl_settings *settings, const char **key, struct rl_error *error);

/* Values as the command line and scene files spell them; RL_ERR_INPUT says what would have been right.
 * `what` names the argument in the message, e.g. "--env-format", or is NULL. */
int rl_parse_texel_format(enum rl_texel_format *format, const char *text, const char *what,
                          struct rl_error *error);
int rl_parse_normal_bits(int *bits, const char *text, const char *what, struct rl_error *error);
/* "off", "auto" (of RL_MARGIN_BOUND), "auto:0.005" (of another bound) or "0.5": the settings' margin_kind and its number. */
int rl_parse_margin(struct rl_settings *settings, const char *text, const char *what, struct rl_error *error);
int rl_parse_frame(enum rl_frame_kind *frame, const char *text, const char *what, struct rl_error *error);
int rl_parse_interpolation(int *interpolation, const char *text, const char *what, struct rl_error *error);

/* "plain, regular, random, exhaustive or reference": what a message says was expected. */
void rl_method_names(char text[], size_t size);

/* "rgba8", "rgb10a2", "r11g11b10f", "rgba16", "rgba16f" or "rgba32f". */
const char *rl_texel_format_name(enum rl_texel_format format);
/* "phong", "gouraud" or "constant". */
const char *rl_interpolation_name(enum rl_interpolation interpolation);
/* "off", "auto:0.02" or "0.5". */
void rl_margin_name(char text[32], const struct rl_settings *settings);
/* "4" to "16", "half" or "float". */
void rl_normal_bits_name(char text[16], int bits);

#endif
