/* Where the program's own data lies: beside a build tree or under an installation prefix.
 *
 *     build tree   DIR/build/roughlight             data in DIR              plug-ins beside the program
 *     installed    PREFIX/bin/roughlight            PREFIX/share/roughlight  PREFIX/lib/roughlight
 *
 * ROUGHLIGHT_DATA, if set, names the data folder (the one that holds shaders/). Programs under build/ at any depth
 * (tests) find the same tree.
 */
#ifndef RL_BASE_PATHS_H
#define RL_BASE_PATHS_H

#include <stddef.h>

#include "base/error.h"

/* The full path of a data file or folder: "shaders", "plots/style.gp", "src/scene/..." is never one.
 * RL_ERR_UNAVAILABLE names the places looked in. */
int rl_path_data(char path[], size_t size, const char *relative, struct rl_error *error);

/* The full path of a plug-in, e.g. "roughlight-oiio.so". */
int rl_path_plugin(char path[], size_t size, const char *name, struct rl_error *error);

#endif
