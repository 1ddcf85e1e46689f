/* Scene files made from one sound scene by replacing a line, in a folder of the test's own. */
#ifndef RL_TESTS_SCENE_FIXTURE_H
#define RL_TESTS_SCENE_FIXTURE_H

#include <stdio.h>
#include <string.h>

#include "base/files.h"
#include "scene/scene.h"
#include "support/check.h"
#include "support/temporary.h"

/* Line numbers are what the tests of messages count on. */
static const char *const sound_scene[] = {
    /*  1 */ "film: {width: 64, height: 48}",
    /*  2 */ "camera:",
    /*  3 */ "  position: [0, 1, 5]",
    /*  4 */ "  target: [0, 0, 0]",
    /*  5 */ "  up: [0, 1, 0]",
    /*  6 */ "  field-of-view: 40",
    /*  7 */ "materials:",
    /*  8 */ "  - name: shiny",
    /*  9 */ "    rr: 30",
    /* 10 */ "    diffuse: [0.1, 0.2, 0.3]",
    /* 11 */ "    highlight: random",
    /* 12 */ "  - name: matt",
    /* 13 */ "    ambient: [0.1, 0.1, 0.1]",
    /* 14 */ "objects:",
    /* 15 */ "  - name: ball",
    /* 16 */ "    shape: sphere",
    /* 17 */ "    material: shiny",
    /* 18 */ "    tessellation: 4",
    /* 19 */ "  - name: ground",
    /* 20 */ "    shape: plane",
    /* 21 */ "    material: matt",
    /* 22 */ "    translate: [0, -1, 0]",
    /* 23 */ "lights:",
    /* 24 */ "  - name: quad",
    /* 25 */ "    polygon: [[-1, 3, 1], [1, 3, 1], [1, 3, 3], [-1, 3, 3]]",
    /* 26 */ "    radiance: [1, 2, 3]",
    /* 27 */ "  - name: triangle",
    /* 28 */ "    polygon:",
    /* 29 */ "      - [3, 0, 0]",
    /* 30 */ "      - [3, 1, 0]",
    /* 31 */ "      - [3, 0, 1]",
    /* 32 */ "    radiance: [1, 1, 1]",
    /* 33 */ "render:",
    /* 34 */ "  samples: 16",
    /* 35 */ "  margin: off",
};
enum { SOUND_LINES = sizeof sound_scene / sizeof sound_scene[0] };

/* Not rl_file_write: it waits for the disk, and these tests write hundreds of files. */
static inline void put_file(const char *path, const void *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/* Writes the sound scene to `path` with `text` in place of lines first..last (from 1); last < first:
 * nothing replaced, `text` (if not NULL) after the end. */
static inline void write_scene(const char *path, int first, int last, const char *text)
{
    static char document[1 << 16];
    size_t length = 0;
    document[0] = '\0';
    for (int line = 1; line <= SOUND_LINES; line++) {
        bool replaced = line >= first && line <= last;
        const char *written = !replaced ? sound_scene[line - 1] : line == first ? text : NULL;
        if (written)
            length += (size_t)snprintf(document + length, sizeof document - length, "%s\n", written);
        assert_true(length < sizeof document);
    }
    if (last < first && text)
        length += (size_t)snprintf(document + length, sizeof document - length, "%s\n", text);
    assert_true(length < sizeof document);
    put_file(path, document, length);
}

#endif
