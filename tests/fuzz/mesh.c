/* Mesh files: the input is a PLY file's bytes, for what of such a file is read here, before assimp gets it. assimp itself is none of this
 * harness's business: it is known to crash and to hang, and runs in a process of its own (src/scene/mesh_file.c). */
#include "fuzz/harness.h"
#include "scene/mesh_import.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct rl_error error = {0};
    char *text = fuzz_text(data, size);
    fuzz_check_error(rl_ply_check(text, size, "mesh.ply", &error), &error);
    free(text);
    return 0;
}
