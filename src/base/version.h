/* What this program is: the facts of its build that results, images and `info` record. */
#ifndef RL_BASE_VERSION_H
#define RL_BASE_VERSION_H

#include <stdbool.h>

struct rl_version {
    const char *version;  /* "0.1.0" */
    const char *commit;   /* 12 hexadecimal digits, or "unknown" outside of a clone */
    bool dirty;           /* whether tracked files differed from that commit */
    const char *code;     /* 16 hexadecimal digits: the hash of the sources built, whatever the commit */
    const char *compiler; /* the first line the compiler says about itself */
    const char *cflags;   /* what it was given */
};

extern const struct rl_version rl_version;

#endif
