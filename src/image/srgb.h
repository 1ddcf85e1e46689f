/* The sRGB transfer function (IEC 61966-2-1), between linear light and the encoded value, both in [0, 1]. */
#ifndef RL_IMAGE_SRGB_H
#define RL_IMAGE_SRGB_H

#include <math.h>

static inline double rl_srgb_encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

static inline double rl_srgb_decode(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

#endif
