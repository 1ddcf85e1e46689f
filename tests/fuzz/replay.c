/* Gives a fuzzer's harness the files of its corpus, one after the other, without the fuzzer. Linked with one of the harnesses beside this
 * file it is a test of `make test`:
 *
 *     build/tests/fuzz/scene                    every file of tests/fuzz/corpus/scene
 *     build/tests/fuzz/scene FILE-OR-FOLDER...  these: what a fuzzer has found
 *
 * Prints "ok - FILE" or "not ok - FILE: why" for each, then "N passed, N failed"; exits with 1 if any failed or there was none. */
#include <dirent.h>
#include <libgen.h>
#include <limits.h>
#include <sys/stat.h>

#include "fuzz/harness.h"
#include "support/replay.h"

enum { SECONDS = 20 };

static size_t n_passed, n_failed;

static void replay_file(const char *path)
{
    char why[128];
    bool passed = replay(why, sizeof why, LLVMFuzzerTestOneInput, path, SECONDS);
    if (passed)
        printf("ok - %s\n", path);
    else
        printf("not ok - %s: %s\n", path, why);
    n_passed += passed;
    n_failed += !passed;
}

static int is_visible(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

static void replay_path(const char *path)
{
    struct stat info;
    struct dirent **entry;
    int n =
        stat(path, &info) == 0 && S_ISDIR(info.st_mode) ? scandir(path, &entry, is_visible, alphasort) : -1;
    if (n < 0)
        replay_file(path);
    for (int i = 0; i < n; i++) {
        char file[PATH_MAX];
        snprintf(file, sizeof file, "%s/%s", path, entry[i]->d_name);
        replay_file(file);
        free(entry[i]);
    }
    if (n >= 0)
        free(entry);
}

int main(int argc, char **argv)
{
    char corpus[PATH_MAX];
    snprintf(corpus, sizeof corpus, "tests/fuzz/corpus/%s", basename(argv[0]));
    if (argc < 2)
        replay_path(corpus);
    for (int i = 1; i < argc; i++)
        replay_path(argv[i]);
    printf("%zu passed, %zu failed\n", n_passed, n_failed);
    return n_failed > 0 || n_passed == 0;
}
