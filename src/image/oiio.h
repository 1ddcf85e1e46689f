/* The interface of the plug-in roughlight-oiio.so (oiio.cpp), the only part of the program that knows
 * OpenImageIO.
 *
 * Private to src/image: library.c loads the plug-in and files.c calls it; everyone else uses image.h. One
 * symbol, RL_OIIO_SYMBOL, is looked up: a struct rl_oiio. Its functions let no exception out; they return
 * RL_OK or fill the error, whose message may have several lines and says nothing of the path.
 */
#ifndef RL_IMAGE_OIIO_H
#define RL_IMAGE_OIIO_H

#include "base/error.h"
#include "image/image.h"

#define RL_OIIO_PLUGIN "roughlight-oiio.so"
#define RL_OIIO_SYMBOL "rl_oiio_interface"
#define RL_OIIO_INTERFACE 1 /* goes up whenever this file changes what a function takes or gives */

/* A picture as its file's header describes it. Files may hold pixels for a part of the picture only, or for
 * more than it. */
struct rl_oiio_header {
    int width, height;               /* of the picture */
    long long x, y;                  /* where in the picture the stored pixels begin */
    int stored_width, stored_height; /* and how many there are */
    int channels; /* may be more than RL_IMAGE_CHANNELS_MAX; only so many have names here */
    char channel_name[RL_IMAGE_CHANNELS_MAX][32];
    int has_depth;          /* a volume, or a deep image: not one value per pixel and channel */
    int integers;           /* stored as integers, of which the largest reads as 1 */
    int unassociated_alpha; /* colour is not multiplied by alpha */
    char colour_space[32];  /* as OpenImageIO calls it; empty: the file does not say */
    double gamma;           /* of a colour space that is a power law; 0: none given */
};

/* Called once per attribute: a string, or NULL and a number. */
typedef void rl_oiio_attribute_visitor(void *user, const char *name, const char *string, double number);

/* Takes the whole encoded file; returns RL_OK or the code of the error that it has filled. */
typedef int rl_oiio_sink(void *user, const void *bytes, size_t size, struct rl_error *error);

struct rl_oiio {
    int interface; /* RL_OIIO_INTERFACE of the plug-in's own build */

    void (*version)(char text[64]);

    /* Opens a file and reads its header. `reader` stays valid until it is closed. */
    int (*open)(void **reader, struct rl_oiio_header *header, const char *path, struct rl_error *error);
    void (*attributes)(void *reader, rl_oiio_attribute_visitor *visit, void *user);
    /* Fills float data[stored_height][stored_width][channels], as stored: not decoded, not multiplied by
     * alpha. */
    int (*read)(void *reader, float *data, struct rl_error *error);
    void (*close)(void *reader);

    /* Encodes to memory. "exr": `pixels` are floats (32-bit, ZIP). "png": bytes, sRGB with unassociated
     * alpha, and numeric attributes become text. Size, channel names and attributes are `image`'s; its data
     * is not looked at. */
    int (*encode)(const char *format, const struct rl_image *image, const void *pixels, rl_oiio_sink *sink,
                  void *user, struct rl_error *error);
};

/* Loads the plug-in on the first call, from any thread; later calls give the same answer. RL_ERR_UNAVAILABLE
 * says what is missing and how to get it. */
int rl_oiio_load(const struct rl_oiio **oiio, struct rl_error *error);

#endif
