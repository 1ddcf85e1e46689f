/* Writes small PNG files of any kind, whole or wrong on purpose: the program itself writes 8-bit sRGB alone. */
#ifndef RL_TESTS_IMAGE_PNG_WRITER_H
#define RL_TESTS_IMAGE_PNG_WRITER_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

struct png_writer {
    unsigned char bytes[8192];
    size_t size;
};

static inline void png_u32(unsigned char out[4], uint32_t value)
{
    for (int i = 0; i < 4; i++)
        out[i] = (unsigned char)(value >> (24 - 8 * i));
}

static inline uint32_t png_crc(const unsigned char *bytes, size_t n)
{
    uint32_t crc = 0xffffffff;
    for (size_t i = 0; i < n; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            crc = crc & 1 ? 0xedb88320 ^ (crc >> 1) : crc >> 1;
    }
    return ~crc;
}

static inline void png_chunk(struct png_writer *png, const char *type, const void *data, size_t n)
{
    unsigned char *out = png->bytes + png->size;
    png_u32(out, (uint32_t)n);
    memcpy(out + 4, type, 4);
    if (n > 0)
        memcpy(out + 8, data, n);
    png_u32(out + 8 + n, png_crc(out + 4, n + 4));
    png->size += n + 12;
}

/* Colour type: 0 grey, 2 RGB, 4 grey and alpha, 6 RGB and alpha. */
static inline void png_begin(struct png_writer *png, uint32_t width, uint32_t height, int depth,
                             int colour_type)
{
    memcpy(png->bytes, "\x89PNG\r\n\x1a\n", 8);
    png->size = 8;
    unsigned char header[13] = {0};
    png_u32(header, width);
    png_u32(header + 4, height);
    header[8] = (unsigned char)depth;
    header[9] = (unsigned char)colour_type;
    png_chunk(png, "IHDR", header, sizeof header);
}

/* Rows with their filter bytes, in one stored block of RFC 1950 and 1951. */
static inline void png_end(struct png_writer *png, const unsigned char *rows, size_t n)
{
    unsigned char data[4096] = {0x78, 0x01, 0x01};
    data[3] = (unsigned char)(n & 255);
    data[4] = (unsigned char)(n >> 8);
    data[5] = (unsigned char)~data[3];
    data[6] = (unsigned char)~data[4];
    memcpy(data + 7, rows, n);
    uint32_t a = 1;
    uint32_t b = 0;
    for (size_t i = 0; i < n; i++) {
        a = (a + rows[i]) % 65521;
        b = (b + a) % 65521;
    }
    png_u32(data + 7 + n, b << 16 | a);
    png_chunk(png, "IDAT", data, n + 11);
    png_chunk(png, "IEND", NULL, 0);
}

#endif
