/* A folder of a test's own, removed with all it holds.
 *
 *     struct temporary t = {0};
 *     temporary_make(&t);
 *     temporary_path(&t, path, "results.db");
 *     temporary_remove(&t);
 */
#ifndef RL_TESTS_TEMPORARY_H
#define RL_TESTS_TEMPORARY_H

#include <assert.h>
#include <ftw.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

struct temporary {
    char folder[128];
};

static inline void temporary_make(struct temporary *t)
{
    const char *base = getenv("TMPDIR");
    int n = snprintf(t->folder, sizeof t->folder, "%s/roughlight-test-XXXXXX", base && *base ? base : "/tmp");
    if (n < 0 || (size_t)n >= sizeof t->folder || !mkdtemp(t->folder)) {
        perror("a temporary folder");
        abort();
    }
}

static inline void temporary_path(const struct temporary *t, char path[PATH_MAX], const char *name)
{
    snprintf(path, PATH_MAX, "%s/%s", t->folder, name);
}

static inline int temporary_unlink(const char *path, const struct stat *info, int kind, struct FTW *where)
{
    (void)info, (void)kind, (void)where;
    return remove(path);
}

static inline void temporary_remove(const struct temporary *t)
{
    nftw(t->folder, temporary_unlink, 16, FTW_DEPTH | FTW_PHYS);
}

#endif
