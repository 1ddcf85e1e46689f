/* Images in memory: 32-bit float, interleaved channels, row 0 at the top, linear light; and their files
 * through OpenImageIO.
 *
 * The colour of a pixel that is covered in part (channel A between 0 and 1) is multiplied by its coverage:
 * associated alpha, as in EXR. Files whose alpha is unassociated, PNG among them, are converted when they are
 * read or written.
 *
 * OpenImageIO is loaded when the first image is read or written (rl_image_read, rl_image_write), never
 * before: it takes 170 ms.
 *
 *     struct rl_image image = {0};
 *     rl_image_allocate(&image, 640, 480, 4, &error);           channels R, G, B, A
 *     rl_image_pixel(&image, x, y)[0] = 1.0f;
 *     rl_image_set_string(&image, "roughlight:scene", "teapot-star.yaml", &error);
 *     rl_image_write(&image, "out.exr", &report, &error);
 *     rl_image_clear(&image);
 */
#ifndef RL_IMAGE_IMAGE_H
#define RL_IMAGE_IMAGE_H

#include <stddef.h>

#include "base/error.h"

enum {
    RL_IMAGE_CHANNELS_MAX = 16,
    RL_IMAGE_ATTRIBUTES_MAX = 64,
    RL_IMAGE_VALUES_MAX = 1 << 30 /* width x height x channels: 16384 x 16384 pixels of R, G, B, A, 4 GiB */
};

struct rl_attribute {
    char name[64];
    char *string; /* owned; NULL: a number */
    double number;
};

struct rl_image {
    int width, height, channels;
    char channel_name[RL_IMAGE_CHANNELS_MAX][32];
    float *data; /* [height][width][channels] */
    size_t n_attributes;
    struct rl_attribute attribute[RL_IMAGE_ATTRIBUTES_MAX];
};

/* What writing could not carry over; never silent: the caller reports it. */
struct rl_write_report {
    size_t
        clipped; /* values outside [0, 1], or without alpha to show them, in a file of integers: the three below */
    size_t nonfinite;    /* NaN or infinite values found; such an image is refused */
    size_t above, below; /* colours over their alpha, and alphas, above 1 and below 0 */
    size_t uncovered;    /* colours of a pixel whose alpha is 0 or less */
};

/* Values that a picture of light does not have, or that not every format holds; never silent either. */
struct rl_image_census {
    size_t values;      /* width x height x channels */
    size_t nonfinite;   /* NaN or infinite */
    size_t negative;    /* finite, below 0; -0 is not */
    size_t large;       /* finite, above 65504, the largest half */
    double least, most; /* of the finite ones; NaN: there are none */
};

/* All zero. 1 channel: Y; 3: R, G, B; 4: R, G, B, A; others: C0, C1, ... RL_ERR_INPUT: a size below 1 or
 * beyond the limits above. What `image` held before is not freed. */
int rl_image_allocate(struct rl_image *image, int width, int height, int channels, struct rl_error *error);
void rl_image_clear(struct rl_image *image);

/* The channel of that name, or -1. */
int rl_image_channel(const struct rl_image *image, const char *name);

static inline float *rl_image_pixel(const struct rl_image *image, int x, int y)
{
    return image->data + ((size_t)y * (size_t)image->width + (size_t)x) * (size_t)image->channels;
}

/* Sets or replaces an attribute; RL_ERR_SYSTEM when the table is full, RL_ERR_INPUT for a name that is empty,
 * too long or not printable ASCII. */
int rl_image_set_string(struct rl_image *image, const char *name, const char *value, struct rl_error *error);
int rl_image_set_number(struct rl_image *image, const char *name, double value, struct rl_error *error);
/* NULL if absent. */
const struct rl_attribute *rl_image_attribute(const struct rl_image *image, const char *name);

void rl_image_census(struct rl_image_census *census, const struct rl_image *image);
/* What a PNG of it will have lost: `clipped` and its parts, for values that are finite. */
void rl_image_clipping(struct rl_write_report *report, const struct rl_image *image);

/* Reads any format OpenImageIO knows, to linear float: integer formats are decoded by the gamma that they
 * state, else from sRGB unless they are tagged linear; alpha is not. Non-finite values are kept: they are for
 * the caller to count (rl_image_census). Of a file with several pictures the first is read; pixels that an EXR file stores
 * outside of its display window are left out, missing ones are 0. Attributes that tell how the file is
 * packed, or are neither a string nor a number, are left out, and those beyond RL_IMAGE_ATTRIBUTES_MAX.
 * RL_ERR_INPUT: no such file, not an image, damaged, or too large. `image` must be empty (zero or cleared)
 * and stays so on an error. */
int rl_image_read(struct rl_image *image, const char *path, struct rl_error *error);

/* Writes .exr (32-bit float, ZIP) or .png (8-bit sRGB, alpha linear and unassociated; channels Y, Y A, R G B
 * or R G B A), atomically; other endings are RL_ERR_INPUT. An image with a NaN or infinite value is refused
 * (RL_ERR_CHECK) with the count and the first pixel's place. Files of equal images are equal: no date but the
 * attributes given.
 *
 * Attributes come back from EXR as they were, but for empty strings, which are lost; from PNG all of them as
 * strings. Names that steer the packing (compression, oiio:..., and so on) are RL_ERR_INPUT. `report` may be
 * NULL. */
int rl_image_write(const struct rl_image *image, const char *path, struct rl_write_report *report,
                   struct rl_error *error);

/* OpenImageIO's version, or the reason why it cannot be loaded. */
int rl_image_library(char version[64], struct rl_error *error);

#endif
