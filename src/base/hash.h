/* 64-bit FNV-1a (Fowler, Noll, Vo; RFC 9923 lists its constants): names contents and cases, not for security.
 *
 *     uint64_t h = RL_HASH_START;
 *     h = rl_hash_bytes(h, data, size);
 *     rl_hash_text(text, h);            16 hexadecimal digits
 */
#ifndef RL_BASE_HASH_H
#define RL_BASE_HASH_H

#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define RL_HASH_START UINT64_C(0xcbf29ce484222325)
#define RL_HASH_TEXT 17 /* bytes rl_hash_text writes, with the final NUL */

static inline uint64_t rl_hash_bytes(uint64_t hash, const void *data, size_t size)
{
    const unsigned char *byte = data;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ byte[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static inline void rl_hash_text(char text[RL_HASH_TEXT], uint64_t hash)
{
    snprintf(text, RL_HASH_TEXT, "%016" PRIx64, hash);
}

#endif
