/* Image files: what is read becomes linear light with associated alpha, what is written is checked first (see
 * image.h). */
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "base/files.h"
#include "image/image.h"
#include "image/oiio.h"
#include "image/png_check.h"
#include "image/srgb.h"

/* Attributes that belong to a file's packing and not to its picture. */
static bool steers_packing(const char *name)
{
    static const char *const prefix[] = {"bmp:",     "dpx:", "exr:", "gif:",   "jpeg:", "oiio:",
                                         "openexr:", "png:", "pnm:", "targa:", "tiff:", "webp:"};
    static const char *const whole[] = {"compression",  "Orientation",    "PixelAspectRatio",
                                        "planarconfig", "ResolutionUnit", "screenWindowWidth",
                                        "XResolution",  "YResolution"};
    for (size_t i = 0; i < sizeof prefix / sizeof prefix[0]; i++)
        if (strncasecmp(name, prefix[i], strlen(prefix[i])) == 0)
            return true;
    for (size_t i = 0; i < sizeof whole / sizeof whole[0]; i++)
        if (strcasecmp(name, whole[i]) == 0)
            return true;
    return false;
}

/* The library's messages may have several lines; ours have one. */
static void join_lines(struct rl_error *error)
{
    if (!error)
        return;
    for (char *c = error->message; *c; c++)
        if (*c == '\n' || *c == '\r')
            *c = ' ';
    size_t length = strlen(error->message);
    while (length > 0 && error->message[length - 1] == ' ')
        error->message[--length] = '\0';
}

/* ---- Reading ---- */

/* Colour spaces by OpenImageIO's names. Rec709 is what it calls PNM files, which are in practice sRGB. */
static bool is_srgb(const struct rl_oiio_header *h)
{
    return strcasecmp(h->colour_space, "sRGB") == 0 || strcasecmp(h->colour_space, "Rec709") == 0;
}

static bool is_linear(const struct rl_oiio_header *h)
{
    return !h->integers || strcasecmp(h->colour_space, "Linear") == 0;
}

static int check_header(const struct rl_oiio_header *h, const char *path, struct rl_error *error)
{
    if (h->has_depth)
        return rl_fail(error, RL_ERR_INPUT,
                       "%s: a volume or deep image, one value per pixel and channel expected", path);
    if (h->channels < 1 || h->channels > RL_IMAGE_CHANNELS_MAX)
        return rl_fail(error, RL_ERR_INPUT, "%s: %d channels, 1 to %d expected", path, h->channels,
                       RL_IMAGE_CHANNELS_MAX);
    const int sizes[2][2] = {{h->width, h->height}, {h->stored_width, h->stored_height}};
    for (int i = 0; i < 2; i++) {
        int width = sizes[i][0];
        int height = sizes[i][1];
        if (width < 1 || height < 1 || width > RL_IMAGE_VALUES_MAX / h->channels / height)
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: %d x %d pixels with %d channels, 1 to %d values in all expected", path, width,
                           height, h->channels, RL_IMAGE_VALUES_MAX);
    }
    bool known = !*h->colour_space || is_srgb(h) || is_linear(h) || h->gamma > 0.0;
    if (h->integers && !known)
        return rl_fail(error, RL_ERR_INPUT, "%s: colour space %s, sRGB, linear or a gamma expected", path,
                       h->colour_space);
    return RL_OK;
}

/* The part of the picture for which there are pixels. */
static void paste(struct rl_image *image, const struct rl_oiio_header *h, const float *stored)
{
    size_t channels = (size_t)image->channels;
    for (int y = 0; y < h->stored_height; y++) {
        long long to_y = y + h->y;
        for (int x = 0; x < h->stored_width; x++) {
            long long to_x = x + h->x;
            const float *from = stored + ((size_t)y * (size_t)h->stored_width + (size_t)x) * channels;
            if (to_x >= 0 && to_x < image->width && to_y >= 0 && to_y < image->height)
                memcpy(rl_image_pixel(image, (int)to_x, (int)to_y), from, channels * sizeof *from);
        }
    }
}

static int read_pixels(struct rl_image *image, const struct rl_oiio *oiio, void *reader,
                       const struct rl_oiio_header *h, struct rl_error *error)
{
    if (h->x == 0 && h->y == 0 && h->width == h->stored_width && h->height == h->stored_height)
        return oiio->read(reader, image->data, error);
    size_t values = (size_t)h->stored_width * (size_t)h->stored_height * (size_t)h->channels;
    float *stored = calloc(values, sizeof *stored);
    if (!stored)
        return rl_fail_memory(error, "an image");
    int status = oiio->read(reader, stored, error);
    if (status == RL_OK)
        paste(image, h, stored);
    free(stored);
    return status;
}

/* To linear light, then to associated alpha. */
static void decode(struct rl_image *image, const struct rl_oiio_header *h)
{
    bool linear = is_linear(h);
    bool power = h->gamma > 0.0 && !is_srgb(h);
    int alpha = rl_image_channel(image, "A");
    if (linear && !(alpha >= 0 && h->unassociated_alpha))
        return;
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        float *pixel = image->data + i * (size_t)image->channels;
        double coverage = alpha >= 0 && h->unassociated_alpha ? pixel[alpha] : 1.0;
        for (int c = 0; c < image->channels; c++) {
            if (c == alpha)
                continue;
            double v = pixel[c];
            if (!linear)
                v = power ? pow(v, h->gamma) : rl_srgb_decode(v);
            pixel[c] = (float)(v * coverage);
        }
    }
}

static void keep_attribute(void *user, const char *name, const char *string, double number)
{
    /* Another program's attribute that does not fit our table is no reason to refuse the picture. */
    if (steers_packing(name))
        return;
    if (string)
        rl_image_set_string(user, name, string, NULL);
    else
        rl_image_set_number(user, name, number, NULL);
}

static int read_opened(struct rl_image *image, const struct rl_oiio *oiio, void *reader,
                       const struct rl_oiio_header *h, const char *path, struct rl_error *error)
{
    int status = check_header(h, path, error);
    if (status != RL_OK)
        return status;
    status = rl_image_allocate(image, h->width, h->height, h->channels, error);
    if (status != RL_OK)
        return status;
    memcpy(image->channel_name, h->channel_name, sizeof image->channel_name);
    oiio->attributes(reader, keep_attribute, image);
    status = read_pixels(image, oiio, reader, h, error);
    if (status == RL_OK) {
        decode(image, h);
        return RL_OK;
    }
    rl_image_clear(image);
    join_lines(error);
    rl_fail_prefix(error, "%s: damaged image", path);
    return status;
}

int rl_image_read(struct rl_image *image, const char *path, struct rl_error *error)
{
    /* Found here and not by the library, whose words for these are many. */
    struct stat info;
    if (stat(path, &info) != 0)
        return rl_fail(error, RL_ERR_INPUT, "%s: cannot open: %s", path, strerror(errno));
    if (!S_ISREG(info.st_mode))
        return rl_fail(error, RL_ERR_INPUT, "%s: not a regular file, an image expected", path);
    if (info.st_size == 0)
        return rl_fail(error, RL_ERR_INPUT, "%s: empty file, an image expected", path);

    int status = rl_png_check(path, error);
    if (status != RL_OK)
        return status;

    const struct rl_oiio *oiio = NULL;
    void *reader = NULL;
    struct rl_oiio_header header;
    status = rl_oiio_load(&oiio, error);
    if (status != RL_OK)
        return status;
    status = oiio->open(&reader, &header, path, error);
    if (status != RL_OK) {
        join_lines(error);
        rl_fail_prefix(error, "%s: not an image that can be read", path);
        return status;
    }
    status = read_opened(image, oiio, reader, &header, path, error);
    oiio->close(reader);
    return status;
}

/* ---- Writing ---- */

static int check_finite(const struct rl_image *image, const char *path, struct rl_write_report *report,
                        struct rl_error *error)
{
    size_t values = (size_t)image->width * (size_t)image->height * (size_t)image->channels;
    size_t first = 0;
    for (size_t i = 0; i < values; i++)
        if (!isfinite(image->data[i]) && report->nonfinite++ == 0)
            first = i;
    if (report->nonfinite == 0)
        return RL_OK;
    size_t pixel = first / (size_t)image->channels;
    return rl_fail(
        error, RL_ERR_CHECK,
        "%s: not written: %zu of %zu values are NaN or infinite, the first at x %zu, y %zu, channel %s", path,
        report->nonfinite, values, pixel % (size_t)image->width, pixel / (size_t)image->width,
        image->channel_name[first % (size_t)image->channels]);
}

static int check_attributes(const struct rl_image *image, const char *path, struct rl_error *error)
{
    for (size_t i = 0; i < image->n_attributes; i++)
        if (steers_packing(image->attribute[i].name))
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: attribute '%s' is the file format's own, another name expected", path,
                           image->attribute[i].name);
    return RL_OK;
}

/* PNG has no channel names: what can be read back is what a reader takes its channels for. */
static int check_png_channels(const struct rl_image *image, const char *path, struct rl_error *error)
{
    static const char *const layout[5][4] = {
        {NULL}, {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    bool fits = image->channels <= 4;
    for (int i = 0; fits && i < image->channels; i++)
        fits = strcmp(image->channel_name[i], layout[image->channels][i]) == 0;
    return fits ? RL_OK
                : rl_fail(error, RL_ERR_INPUT,
                          "%s: %d channel(s) beginning with %s, a PNG file holds Y, Y A, R G B or R G B A",
                          path, image->channels, image->channel_name[0]);
}

static unsigned char to_byte(double value, struct rl_write_report *report)
{
    if (value < 0.0 || value > 1.0) {
        report->clipped++;
        report->below += value < 0.0;
        report->above += value > 1.0;
        value = value < 0.0 ? 0.0 : 1.0;
    }
    return (unsigned char)(255.0 * value + 0.5);
}

static void encode_pixel(unsigned char *bytes, const float *pixel, int channels, int alpha,
                         struct rl_write_report *report)
{
    double coverage = alpha >= 0 ? pixel[alpha] : 1.0;
    for (int c = 0; c < channels; c++) {
        double value = pixel[c];
        if (c == alpha) {
            bytes[c] = to_byte(value, report);
            continue;
        }
        if (coverage > 0.0) {
            value /= coverage;
        } else if (value != 0.0) {
            /* Light from a pixel that is not covered cannot be told in unassociated alpha. */
            report->clipped++;
            report->uncovered++;
            value = 0.0;
        }
        /* Clipped before it is encoded: the curve has no meaning outside. */
        bytes[c] =
            value >= 0.0 && value <= 1.0 ? to_byte(rl_srgb_encode(value), report) : to_byte(value, report);
    }
}

void rl_image_clipping(struct rl_write_report *report, const struct rl_image *image)
{
    size_t pixels = (size_t)image->width * (size_t)image->height, channels = (size_t)image->channels;
    unsigned char bytes[RL_IMAGE_CHANNELS_MAX];
    int alpha = rl_image_channel(image, "A");
    *report = (struct rl_write_report){0};
    for (size_t i = 0; i < pixels; i++)
        encode_pixel(bytes, image->data + i * channels, image->channels, alpha, report);
}

static unsigned char *encode_bytes(const struct rl_image *image, struct rl_write_report *report)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    size_t channels = (size_t)image->channels;
    unsigned char *bytes = malloc(pixels * channels + 1); /* + 1: never zero, which malloc may refuse */
    int alpha = rl_image_channel(image, "A");
    for (size_t i = 0; bytes && i < pixels; i++)
        encode_pixel(bytes + i * channels, image->data + i * channels, image->channels, alpha, report);
    return bytes;
}

struct destination {
    const char *path;
    bool reached; /* the picture was encoded; errors from there on name the path themselves */
};

static int save(void *user, const void *bytes, size_t size, struct rl_error *error)
{
    struct destination *to = user;
    to->reached = true;
    return rl_file_write(to->path, bytes, size, error);
}

/* Encoded in memory, so that one place writes files, atomically, and knows why it could not. */
static int write_as(const char *format, const struct rl_image *image, const void *pixels, const char *path,
                    struct rl_error *error)
{
    const struct rl_oiio *oiio = NULL;
    int status = rl_oiio_load(&oiio, error);
    if (status != RL_OK)
        return status;
    struct destination to = {.path = path};
    status = oiio->encode(format, image, pixels, save, &to, error);
    if (status == RL_OK || to.reached)
        return status;
    join_lines(error);
    rl_fail_prefix(error, "%s: cannot be encoded", path);
    return status;
}

static int write_png(const struct rl_image *image, const char *path, struct rl_write_report *report,
                     struct rl_error *error)
{
    int status = check_png_channels(image, path, error);
    if (status != RL_OK)
        return status;
    unsigned char *bytes = encode_bytes(image, report);
    if (!bytes)
        return rl_fail_memory(error, "the bytes of a PNG file");
    status = write_as("png", image, bytes, path, error);
    free(bytes);
    return status;
}

int rl_image_write(const struct rl_image *image, const char *path, struct rl_write_report *report,
                   struct rl_error *error)
{
    struct rl_write_report unwanted;
    if (!report)
        report = &unwanted;
    *report = (struct rl_write_report){0};
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash ? slash : path, '.');
    bool exr = dot && strcasecmp(dot, ".exr") == 0;
    bool png = dot && strcasecmp(dot, ".png") == 0;
    if (!exr && !png)
        return rl_fail(error, RL_ERR_INPUT,
                       "%s: unknown image format, a name ending in .exr or .png expected", path);
    if (!image->data)
        return rl_fail(error, RL_ERR_INPUT, "%s: an empty image cannot be written", path);
    int status = check_finite(image, path, report, error);
    if (status == RL_OK)
        status = check_attributes(image, path, error);
    if (status != RL_OK)
        return status;
    return exr ? write_as("exr", image, image->data, path, error) : write_png(image, path, report, error);
}
