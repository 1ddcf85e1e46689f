/* Whether a PNG file is whole. Private to src/image: libpng finds most damage too, but prints about it to
 * stderr on its own account, and takes a file without its last chunk. */
#ifndef RL_IMAGE_PNG_CHECK_H
#define RL_IMAGE_PNG_CHECK_H

#include "base/error.h"

/* Follows the chunks of the file at `path` to IEND and compares their checksums (PNG specification, 3rd
 * edition, section 5). RL_OK for a whole file, and for one that does not begin as PNG files do. RL_ERR_INPUT
 * names the chunk and where it begins. */
int rl_png_check(const char *path, struct rl_error *error);

#endif
