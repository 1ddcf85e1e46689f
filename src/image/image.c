/* Images in memory and their attributes (see image.h). */
#include "image/image.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void name_channels(struct rl_image *image)
{
    static const char *const colour[] = {"R", "G", "B", "A"};
    for (int i = 0; i < image->channels; i++) {
        char *name = image->channel_name[i];
        if (image->channels == 1)
            snprintf(name, sizeof image->channel_name[i], "Y");
        else if (image->channels == 3 || image->channels == 4)
            snprintf(name, sizeof image->channel_name[i], "%s", colour[i]);
        else
            snprintf(name, sizeof image->channel_name[i], "C%d", i);
    }
}

int rl_image_allocate(struct rl_image *image, int width, int height, int channels, struct rl_error *error)
{
    if (width < 1 || height < 1 || channels < 1 || channels > RL_IMAGE_CHANNELS_MAX)
        return rl_fail(error, RL_ERR_INPUT,
                       "image of %d x %d pixels with %d channels: at least 1 x 1 with 1 to %d expected",
                       width, height, channels, RL_IMAGE_CHANNELS_MAX);
    /* Checked by division: the product of three ints may overflow 64 bits. */
    size_t row = (size_t)width * (size_t)channels;
    if (row > RL_IMAGE_VALUES_MAX / (size_t)height)
        return rl_fail(error, RL_ERR_INPUT,
                       "image of %d x %d pixels with %d channels: at most %d values in all expected", width,
                       height, channels, RL_IMAGE_VALUES_MAX);
    float *data = calloc(row * (size_t)height, sizeof *data);
    if (!data)
        return rl_fail_memory(error, "an image");
    *image = (struct rl_image){.width = width, .height = height, .channels = channels, .data = data};
    name_channels(image);
    return RL_OK;
}

void rl_image_clear(struct rl_image *image)
{
    for (size_t i = 0; i < image->n_attributes; i++)
        free(image->attribute[i].string);
    free(image->data);
    *image = (struct rl_image){0};
}

int rl_image_channel(const struct rl_image *image, const char *name)
{
    for (int i = 0; i < image->channels; i++)
        if (strcmp(image->channel_name[i], name) == 0)
            return i;
    return -1;
}

static bool valid_name(const char *name)
{
    size_t length = 0;
    for (; name[length]; length++)
        if (name[length] < ' ' || name[length] > '~')
            return false;
    return length > 0 && length < sizeof((struct rl_attribute *)NULL)->name;
}

/* n_attributes if there is none. */
static size_t find(const struct rl_image *image, const char *name)
{
    size_t i = 0;
    while (i < image->n_attributes && strcmp(image->attribute[i].name, name) != 0)
        i++;
    return i;
}

/* Takes over `string`, and frees it on failure. */
static int set(struct rl_image *image, const char *name, char *string, double number, struct rl_error *error)
{
    size_t i = find(image, name);
    int status = RL_OK;
    if (!valid_name(name))
        status = rl_fail(error, RL_ERR_INPUT,
                         "image attribute '%.80s': a name of 1 to %zu ASCII characters expected", name,
                         sizeof image->attribute[0].name - 1);
    else if (i == RL_IMAGE_ATTRIBUTES_MAX)
        status =
            rl_fail(error, RL_ERR_SYSTEM, "image attribute '%s': there are %d already, and no room for more",
                    name, RL_IMAGE_ATTRIBUTES_MAX);
    if (status != RL_OK) {
        free(string);
        return status;
    }
    struct rl_attribute *a = &image->attribute[i];
    if (i == image->n_attributes) {
        image->n_attributes++;
        *a = (struct rl_attribute){0};
        snprintf(a->name, sizeof a->name, "%s", name);
    }
    free(a->string);
    a->string = string;
    a->number = number;
    return RL_OK;
}

int rl_image_set_string(struct rl_image *image, const char *name, const char *value, struct rl_error *error)
{
    char *copy = strdup(value);
    return copy ? set(image, name, copy, 0.0, error) : rl_fail_memory(error, "an image attribute");
}

int rl_image_set_number(struct rl_image *image, const char *name, double value, struct rl_error *error)
{
    return set(image, name, NULL, value, error);
}

const struct rl_attribute *rl_image_attribute(const struct rl_image *image, const char *name)
{
    size_t i = find(image, name);
    return i < image->n_attributes ? &image->attribute[i] : NULL;
}

void rl_image_census(struct rl_image_census *census, const struct rl_image *image)
{
    static const float largest_half = 65504.0F;
    struct rl_image_census c = {.values =
                                    (size_t)image->width * (size_t)image->height * (size_t)image->channels,
                                .least = NAN,
                                .most = NAN};
    for (size_t i = 0; i < c.values; i++) {
        float v = image->data[i];
        c.nonfinite += !isfinite(v);
        if (!isfinite(v))
            continue;
        c.negative += v < 0.0F;
        c.large += v > largest_half;
        c.least = fmin(c.least, v); /* the number, where one of both is none */
        c.most = fmax(c.most, v);
    }
    *census = c;
}
