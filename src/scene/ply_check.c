/* Reads a PLY file (Turk 1994) far enough to tell whether it is whole (see mesh_import.h).
 *
 * After the header come, element by element, rows of the properties it announced: in ASCII one row a line,
 * in binary without a gap. A list property is a count and that many entries. */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/mesh_import.h"

enum { ELEMENTS_MAX = 32, PROPERTIES_MAX = 64, WORDS_MAX = 8 };

enum type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64, NO_TYPE };

static const struct {
    const char *name, *alias;
    size_t bytes;
} types[] = {
    [INT8] = {"char", "int8", 1},        [UINT8] = {"uchar", "uint8", 1},
    [INT16] = {"short", "int16", 2},     [UINT16] = {"ushort", "uint16", 2},
    [INT32] = {"int", "int32", 4},       [UINT32] = {"uint", "uint32", 4},
    [FLOAT32] = {"float", "float32", 4}, [FLOAT64] = {"double", "float64", 8},
};

struct property {
    enum type count; /* NO_TYPE: not a list */
    enum type value;
    bool indices; /* of vertices, for a face */
};

struct element {
    char name[32];
    unsigned long long rows;
    size_t n_properties;
    struct property property[PROPERTIES_MAX];
};

struct ply {
    const char *path;
    struct rl_error *error;
    const char *at, *end;
    bool binary, big_endian;
    size_t line; /* of `at`, in the header and in ASCII */
    size_t n_elements;
    struct element element[ELEMENTS_MAX];
    unsigned long long n_vertices;
};

/* ---- The header ---- */

static int fail_header(const struct ply *p, const char *found, const char *expected)
{
    return rl_fail(p->error, RL_ERR_INPUT, "%s:%zu: found %s, expected %s", p->path, p->line, found,
                   expected);
}

/* The next line without its end, cut into words at blanks; *n is 0 for an empty one. False at the end of
 * the file. */
static bool next_line(struct ply *p, char line[256], char *word[WORDS_MAX], size_t *n)
{
    const char *newline = memchr(p->at, '\n', (size_t)(p->end - p->at));
    if (!newline)
        return false;
    size_t length = (size_t)(newline - p->at);
    snprintf(line, 256, "%.*s", (int)(length < 255 ? length : 255), p->at);
    p->at = newline + 1;
    p->line++;
    *n = 0;
    char *rest = NULL;
    for (char *w = strtok_r(line, " \t\r", &rest); w && *n < WORDS_MAX; w = strtok_r(NULL, " \t\r", &rest))
        word[(*n)++] = w;
    return true;
}

static enum type find_type(const char *name)
{
    for (int i = 0; i < NO_TYPE; i++)
        if (strcmp(name, types[i].name) == 0 || strcmp(name, types[i].alias) == 0)
            return (enum type)i;
    return NO_TYPE;
}

static int read_format(struct ply *p, char *const word[], size_t n)
{
    const char *format = n > 1 ? word[1] : "";
    p->binary = strncmp(format, "binary_", 7) == 0;
    p->big_endian = strcmp(format, "binary_big_endian") == 0;
    if (strcmp(format, "ascii") != 0 && strcmp(format, "binary_little_endian") != 0 && !p->big_endian)
        return fail_header(p, "an unknown format", "ascii, binary_little_endian or binary_big_endian");
    return RL_OK;
}

static int read_element(struct ply *p, char *const word[], size_t n)
{
    if (p->n_elements == ELEMENTS_MAX)
        return fail_header(p, "more than 32 elements", "a PLY header");
    struct element *e = &p->element[p->n_elements++];
    char *end = NULL;
    errno = 0;
    if (n == 3)
        e->rows = strtoull(word[2], &end, 10);
    if (!end || *end != '\0' || errno != 0 || !isdigit((unsigned char)word[2][0]))
        return fail_header(p, "an element without a number of rows", "element NAME NUMBER");
    snprintf(e->name, sizeof e->name, "%.31s", word[1]);
    if (strcmp(e->name, "vertex") == 0)
        p->n_vertices = e->rows;
    return RL_OK;
}

static int read_property(struct ply *p, char *const word[], size_t n)
{
    bool list = n == 5 && strcmp(word[1], "list") == 0;
    if (p->n_elements == 0 || (!list && n != 3))
        return fail_header(p, "a property out of place",
                           "property TYPE NAME or property list TYPE TYPE NAME, after element");
    struct element *e = &p->element[p->n_elements - 1];
    if (e->n_properties == PROPERTIES_MAX)
        return fail_header(p, "more than 64 properties", "a PLY header");
    struct property *property = &e->property[e->n_properties++];
    property->count = list ? find_type(word[2]) : NO_TYPE;
    property->value = find_type(word[list ? 3 : 1]);
    property->indices = list && strcmp(e->name, "face") == 0 && strncmp(word[4], "vertex_ind", 10) == 0;
    if (property->value == NO_TYPE || (list && property->count >= FLOAT32))
        return fail_header(p, "an unknown type",
                           "char to double, and an integer type for the length of a list");
    return RL_OK;
}

static int read_header(struct ply *p)
{
    char line[256], *word[WORDS_MAX];
    size_t n;
    bool format = false;
    if (!next_line(p, line, word, &n) || n != 1 || strcmp(word[0], "ply") != 0)
        return rl_fail(p->error, RL_ERR_INPUT, "%s:1: found no PLY header, expected the word ply", p->path);
    while (next_line(p, line, word, &n)) {
        int status = RL_OK;
        if (n == 0)
            continue;
        if (strcmp(word[0], "end_header") == 0)
            return format ? RL_OK
                          : fail_header(p, "a header without a format", "format ascii 1.0 or the like");
        if (strcmp(word[0], "format") == 0) {
            status = read_format(p, word, n);
            format = true;
        } else if (strcmp(word[0], "element") == 0) {
            status = read_element(p, word, n);
        } else if (strcmp(word[0], "property") == 0) {
            status = read_property(p, word, n);
        } /* else a comment, or what writers put in place of one */
        if (status != RL_OK)
            return status;
    }
    return rl_fail(p->error, RL_ERR_INPUT, "%s: found a file cut off in its header, expected end_header",
                   p->path);
}

/* ---- The rows ---- */

static int fail_cut(const struct ply *p, const struct element *e, unsigned long long row)
{
    return rl_fail(p->error, RL_ERR_INPUT,
                   "%s: found a file cut off after %llu of %llu rows of %s, expected all of them", p->path,
                   row, e->rows, e->name);
}

static int fail_index(const struct ply *p, const struct element *e, unsigned long long row, double index)
{
    return rl_fail(p->error, RL_ERR_INPUT,
                   "%s: found the vertex index %.0f in row %llu of %s, expected 0 to %llu", p->path, index,
                   row, e->name, p->n_vertices - 1);
}

/* One value as ASCII; false where the line has none left or something else. */
static bool scan_value(struct ply *p, double *value)
{
    while (p->at < p->end && (*p->at == ' ' || *p->at == '\t'))
        p->at++;
    if (p->at == p->end || isspace((unsigned char)*p->at))
        return false;
    char *end;
    *value = strtod(p->at, &end);
    if (end == p->at || (end < p->end && !isspace((unsigned char)*end)))
        return false;
    p->at = end;
    return true;
}

static double as_number(enum type type, uint64_t bits)
{
    float f;
    double d;
    uint32_t low = (uint32_t)bits;
    switch (type) {
    case INT8:
        return (int8_t)bits;
    case INT16:
        return (int16_t)bits;
    case INT32:
        return (int32_t)bits;
    case FLOAT32:
        memcpy(&f, &low, sizeof f);
        return (double)f;
    case FLOAT64:
        memcpy(&d, &bits, sizeof d);
        return d;
    default:
        return (double)bits;
    }
}

static bool take_value(struct ply *p, enum type type, double *value)
{
    if (!p->binary)
        return scan_value(p, value);
    size_t n = types[type].bytes;
    if ((size_t)(p->end - p->at) < n)
        return false;
    uint64_t bits = 0;
    for (size_t i = 0; i < n; i++)
        bits |= (uint64_t)(unsigned char)p->at[i] << 8 * (p->big_endian ? n - 1 - i : i);
    p->at += n;
    *value = as_number(type, bits);
    return true;
}

static int check_list(struct ply *p, const struct element *e, const struct property *property,
                      unsigned long long row)
{
    double count, value;
    if (!take_value(p, property->count, &count))
        return fail_cut(p, e, row);
    if (!(count >= (property->indices ? 3.0 : 0.0)) || count != floor(count) || count > UINT32_MAX)
        return rl_fail(p->error, RL_ERR_INPUT, "%s: found a list of %g in row %llu of %s, expected %s",
                       p->path, count, row, e->name,
                       property->indices ? "3 vertices or more" : "a whole number of entries");
    for (uint64_t i = 0; i < (uint64_t)count; i++) {
        if (!take_value(p, property->value, &value))
            return fail_cut(p, e, row);
        if (property->indices && !(value >= 0.0 && value < (double)p->n_vertices))
            return fail_index(p, e, row, value);
    }
    return RL_OK;
}

/* ASCII rows end with their line, and empty lines are no rows. */
static int end_row(struct ply *p, const struct element *e, unsigned long long row)
{
    while (p->at < p->end && (*p->at == ' ' || *p->at == '\t' || *p->at == '\r'))
        p->at++;
    if (p->at < p->end && *p->at != '\n')
        return rl_fail(p->error, RL_ERR_INPUT,
                       "%s: found more values than announced in row %llu of %s, expected one row a line",
                       p->path, row, e->name);
    return RL_OK;
}

static int check_row(struct ply *p, const struct element *e, unsigned long long row)
{
    while (!p->binary && p->at < p->end && isspace((unsigned char)*p->at))
        p->at++;
    for (size_t i = 0; i < e->n_properties; i++) {
        const struct property *property = &e->property[i];
        double value;
        int status = RL_OK;
        if (property->count != NO_TYPE)
            status = check_list(p, e, property, row);
        else if (!take_value(p, property->value, &value))
            status = fail_cut(p, e, row);
        if (status != RL_OK)
            return status;
    }
    return p->binary ? RL_OK : end_row(p, e, row);
}

int rl_ply_check(const char *data, size_t size, const char *path, struct rl_error *error)
{
    struct ply *p = calloc(1, sizeof *p);
    if (!p)
        return rl_fail_memory(error, path);
    *p = (struct ply){.path = path, .error = error, .at = data, .end = data + size};
    int status = read_header(p);
    for (size_t i = 0; i < p->n_elements && status == RL_OK; i++) {
        const struct element *e = &p->element[i];
        /* Rows without a property would take no bytes, however many are announced. */
        for (unsigned long long row = 0; e->n_properties > 0 && row < e->rows && status == RL_OK; row++)
            status = check_row(p, e, row);
    }
    free(p);
    return status;
}
