/* The only source that includes the generated header, so that a new commit recompiles this file alone. */
#include "base/version.h"

#include "gen/version.h"

const struct rl_version rl_version = {
    .version = RL_VERSION,
    .commit = RL_COMMIT,
    .dirty = RL_DIRTY,
    .code = RL_CODE,
    .compiler = RL_COMPILER,
    .cflags = RL_CFLAGS,
};
