/* See kept.h. */
#include "gpu/kept.h"

#include <stdlib.h>

/* Of those nobody uses. A program counts for about what llvmpipe keeps of it: its code for each state it was drawn in. */
static const size_t most_bytes[RL_KEPT_KINDS] = {
    [RL_KEPT_PROGRAM] = (size_t)64 << 20,
    [RL_KEPT_TEXTURE] = (size_t)192 << 20,
    [RL_KEPT_STORAGE] = (size_t)128 << 20,
};

static void delete_object(const struct rl_gl *gl, enum rl_kept_kind kind, GLuint id)
{
    if (kind == RL_KEPT_PROGRAM)
        gl->DeleteProgram(id);
    else
        gl->DeleteTextures(1, &id);
}

GLuint rl_kept_take(struct rl_kept *kept, enum rl_kept_kind kind, uint64_t key)
{
    kept->calls++;
    for (size_t i = 0; i < kept->n; i++) {
        struct rl_kept_object *o = &kept->object[i];
        if (o->kind != kind || o->key != key || (kind == RL_KEPT_STORAGE && o->users > 0))
            continue;
        o->users++;
        o->used = kept->calls;
        return o->id;
    }
    return 0;
}

static void drop(struct rl_kept *kept, const struct rl_gl *gl, size_t i)
{
    struct rl_kept_object *o = &kept->object[i];
    delete_object(gl, o->kind, o->id);
    kept->bytes[o->kind] -= o->bytes;
    *o = kept->object[--kept->n];
}

static void keep_to_the_share(struct rl_kept *kept, const struct rl_gl *gl, enum rl_kept_kind kind)
{
    while (kept->bytes[kind] > most_bytes[kind]) {
        size_t oldest = kept->n;
        for (size_t i = 0; i < kept->n; i++)
            if (kept->object[i].kind == kind && kept->object[i].users == 0 &&
                (oldest == kept->n || kept->object[i].used < kept->object[oldest].used))
                oldest = i;
        if (oldest == kept->n)
            return;
        drop(kept, gl, oldest);
    }
}

int rl_kept_add(struct rl_kept *kept, const struct rl_gl *gl, enum rl_kept_kind kind, uint64_t key, GLuint id,
                size_t bytes, struct rl_error *error)
{
    if (kept->n == kept->room) {
        size_t room = 2 * kept->room + 16;
        struct rl_kept_object *grown = realloc(kept->object, room * sizeof *grown);
        if (!grown) {
            delete_object(gl, kind, id);
            return rl_fail_memory(error, "what OpenGL keeps");
        }
        kept->object = grown;
        kept->room = room;
    }
    kept->object[kept->n++] = (struct rl_kept_object){
        .key = key, .kind = kind, .id = id, .users = 1, .bytes = bytes, .used = ++kept->calls};
    kept->bytes[kind] += bytes;
    keep_to_the_share(kept, gl, kind);
    return RL_OK;
}

size_t rl_kept_bytes(const struct rl_kept *kept, enum rl_kept_kind kind, GLuint id)
{
    for (size_t i = 0; i < kept->n; i++)
        if (kept->object[i].kind == kind && kept->object[i].id == id)
            return kept->object[i].bytes;
    return 0;
}

void rl_kept_release(struct rl_kept *kept, const struct rl_gl *gl, enum rl_kept_kind kind, GLuint id)
{
    for (size_t i = 0; i < kept->n; i++)
        if (kept->object[i].kind == kind && kept->object[i].id == id && kept->object[i].users > 0) {
            kept->object[i].users--;
            keep_to_the_share(kept, gl, kind);
            return;
        }
}

void rl_kept_clear(struct rl_kept *kept, const struct rl_gl *gl)
{
    for (size_t i = 0; i < kept->n; i++)
        delete_object(gl, kept->object[i].kind, kept->object[i].id);
    free(kept->object);
    *kept = (struct rl_kept){0};
}
