/* The files in tests/hard/scenes, by name. Include after cmocka.h. One that begins with "# refused: WORDS" cannot be loaded, and the error has these
 * words.
 *
 *     struct scene_files files;
 *     scene_files_list(&files);      files.n, files.name[i], files.path[i], files.refused[i]
 */
#ifndef RL_TESTS_HARD_SCENE_FILES_H
#define RL_TESTS_HARD_SCENE_FILES_H

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/paths.h"
#include "support/check.h"

enum { SCENE_FILES_MAX = 64 };

struct scene_files {
    size_t n;
    char name[SCENE_FILES_MAX][64];
    char path[SCENE_FILES_MAX][1024];
    char refused[SCENE_FILES_MAX][128]; /* "": it can be loaded */
};

static inline int scene_files_is_one(const struct dirent *entry)
{
    size_t length = strlen(entry->d_name);
    return length > 5 && strcmp(entry->d_name + length - 5, ".yaml") == 0;
}

static inline void scene_files_read_header(char *refused, size_t size, const char *path)
{
    static const char mark[] = "# refused: ";
    char line[256] = "";
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    refused[0] = '\0';
    if (fgets(line, sizeof line, file) && strncmp(line, mark, sizeof mark - 1) == 0) {
        line[strcspn(line, "\n")] = '\0';
        snprintf(refused, size, "%.127s", line + sizeof mark - 1);
    }
    fclose(file);
}

static inline void scene_files_list(struct scene_files *files)
{
    struct rl_error error;
    char folder[896];
    struct dirent **entry;
    check_ok(rl_path_data(folder, sizeof folder, "tests/hard/scenes", &error), &error);
    int n = scandir(folder, &entry, scene_files_is_one, alphasort);
    assert_in_range(n, 1, SCENE_FILES_MAX);
    files->n = (size_t)n;
    for (size_t i = 0; i < files->n; i++) {
        snprintf(files->name[i], sizeof files->name[i], "%.*s", (int)strcspn(entry[i]->d_name, "."),
                 entry[i]->d_name);
        snprintf(files->path[i], sizeof files->path[i], "%.880s/%.120s", folder, entry[i]->d_name);
        scene_files_read_header(files->refused[i], sizeof files->refused[i], files->path[i]);
        free(entry[i]);
    }
    free(entry);
}

#endif
