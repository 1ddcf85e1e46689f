/* Follows the chunks of a PNG file (see png_check.h). */
#include "image/png_check.h"

#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* CRC-32 of ISO 3309, four bits at a time: entry i is i x^28 modulo the (reflected) polynomial 0xedb88320. */
static uint32_t crc_update(uint32_t crc, const unsigned char *bytes, size_t n)
{
    static const uint32_t table[16] = {
        0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4, 0x4db26158, 0x5005713c,
        0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c, 0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c,
    };
    for (size_t i = 0; i < n; i++) {
        crc = table[(crc ^ bytes[i]) & 15] ^ (crc >> 4);
        crc = table[(crc ^ (bytes[i] >> 4)) & 15] ^ (crc >> 4);
    }
    return crc;
}

static uint32_t big_endian(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

struct chunk {
    char type[5];
    uint32_t length;
    long start; /* in the file, for messages */
};

static int fail(const struct chunk *chunk, const char *path, const char *what, struct rl_error *error)
{
    return rl_fail(error, RL_ERR_INPUT, "%s: damaged PNG file: chunk %s at byte %ld %s", path, chunk->type,
                   chunk->start, what);
}

static int check_chunk(FILE *file, const struct chunk *chunk, const char *path, struct rl_error *error)
{
    unsigned char buffer[4096];
    uint32_t crc = crc_update(0xffffffff, (const unsigned char *)chunk->type, 4);
    for (uint32_t left = chunk->length; left > 0;) {
        size_t n = fread(buffer, 1, left < sizeof buffer ? left : sizeof buffer, file);
        if (n == 0)
            return fail(chunk, path, "is cut short", error);
        crc = crc_update(crc, buffer, n);
        left -= (uint32_t)n;
    }
    if (fread(buffer, 1, 4, file) != 4)
        return fail(chunk, path, "is cut short", error);
    if (big_endian(buffer) != (crc ^ 0xffffffff))
        return fail(chunk, path, "does not match its checksum", error);
    return RL_OK;
}

static int check_chunks(FILE *file, const char *path, struct rl_error *error)
{
    struct chunk chunk = {.type = "IHDR"};
    do {
        unsigned char head[8];
        chunk.start = ftell(file);
        if (fread(head, 1, sizeof head, file) != sizeof head)
            return rl_fail(error, RL_ERR_INPUT,
                           "%s: damaged PNG file: ends at byte %ld without its last chunk, IEND", path,
                           chunk.start);
        chunk.length = big_endian(head);
        memcpy(chunk.type, head + 4, 4);
        for (int i = 0; i < 4; i++)
            if (!isalpha((unsigned char)chunk.type[i]))
                return rl_fail(error, RL_ERR_INPUT,
                               "%s: damaged PNG file: no chunk at byte %ld, one expected", path, chunk.start);
        int status = check_chunk(file, &chunk, path, error);
        if (status != RL_OK)
            return status;
    } while (strcmp(chunk.type, "IEND") != 0);
    return RL_OK;
}

int rl_png_check(const char *path, struct rl_error *error)
{
    static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    unsigned char begin[sizeof signature];
    FILE *file = fopen(path, "rb");
    if (!file)
        return rl_fail(error, RL_ERR_INPUT, "%s: cannot open: %s", path, strerror(errno));
    int status = RL_OK;
    size_t n = fread(begin, 1, sizeof begin, file);
    if (n < 4 || memcmp(begin, signature, 4) != 0)
        status = RL_OK; /* another format, or none */
    else if (n < sizeof begin || memcmp(begin, signature, sizeof begin) != 0)
        status = rl_fail(error, RL_ERR_INPUT,
                         "%s: damaged PNG file: cut short or converted as text in its first 8 bytes", path);
    else
        status = check_chunks(file, path, error);
    fclose(file);
    return status;
}
