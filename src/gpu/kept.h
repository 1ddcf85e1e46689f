/* OpenGL objects kept from scene to scene: what took long to make (programs, normal maps, memory) and would be made the same again.
 *
 *     id = rl_kept_take(&gpu->kept, RL_KEPT_PROGRAM, key);            one of that key, which has one user more now
 *     if (!id) { id = make(...); rl_kept_add(&gpu->kept, gl, RL_KEPT_PROGRAM, key, id, bytes, &error); }
 *     rl_kept_release(&gpu->kept, gl, RL_KEPT_PROGRAM, id);
 *
 * Equal keys stand for equal contents: nobody may change an object after it was added. Storage is the exception: textures of one size and
 * format that every user draws anew, and so one user's at a time. Those without users stay until all of
 * a kind take more than their share of memory; then the one that was used least lately goes first.
 */
#ifndef RL_GPU_KEPT_H
#define RL_GPU_KEPT_H

#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "gpu/gl.h"

enum rl_kept_kind { RL_KEPT_PROGRAM, RL_KEPT_TEXTURE, RL_KEPT_STORAGE, RL_KEPT_KINDS };

struct rl_kept_object {
    uint64_t key;
    enum rl_kept_kind kind;
    GLuint id;
    int users;
    size_t bytes;
    uint64_t used; /* when, by the count of calls */
};

struct rl_kept {
    size_t n, room;
    struct rl_kept_object *object;
    size_t bytes[RL_KEPT_KINDS]; /* of all, in use or not */
    uint64_t calls;
};

/* 0 if there is none; of storage, none that has no user. */
GLuint rl_kept_take(struct rl_kept *kept, enum rl_kept_kind kind, uint64_t key);

/* The object is the cache's from now on, its caller the first user. On an error it is deleted. */
int rl_kept_add(struct rl_kept *kept, const struct rl_gl *gl, enum rl_kept_kind kind, uint64_t key, GLuint id,
                size_t bytes, struct rl_error *error);

/* As it was added; 0 if there is none. */
size_t rl_kept_bytes(const struct rl_kept *kept, enum rl_kept_kind kind, GLuint id);

/* 0, or what was never added: nothing to do. */
void rl_kept_release(struct rl_kept *kept, const struct rl_gl *gl, enum rl_kept_kind kind, GLuint id);

/* Deletes all of them, users or not. */
void rl_kept_clear(struct rl_kept *kept, const struct rl_gl *gl);

#endif
