/* Builds the tree from libyaml's events and makes messages from it (see yaml_tree.h). */
#include "scene/yaml_tree.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

struct reader {
    yaml_parser_t parser;
    const char *path, *text;
    size_t size;
    struct rl_error *error;
};

/* ---- Messages ---- */

/* Copies text, cut at 40 characters, with everything but printable ASCII as \xNN. */
static void quote(char words[], size_t size, const char *text)
{
    size_t length = (size_t)snprintf(words, size, "'");
    for (size_t i = 0; text[i] && length + 8 < size; i++) {
        if (i == 40) {
            length += (size_t)snprintf(words + length, size - length, "...");
            break;
        }
        unsigned char c = (unsigned char)text[i];
        length += (size_t)snprintf(words + length, size - length, isprint(c) ? "%c" : "\\x%02x", c);
    }
    snprintf(words + length, size - length, "'");
}

void rl_yaml_describe(char words[], size_t size, const struct rl_yaml_node *node)
{
    if (!node || (node->kind == RL_YAML_SCALAR && node->text[0] == '\0'))
        snprintf(words, size, "nothing");
    else if (node->kind == RL_YAML_SCALAR)
        quote(words, size, node->text);
    else if (node->kind == RL_YAML_SEQUENCE)
        snprintf(words, size, "a list of %zu", node->n_children);
    else
        snprintf(words, size, "a mapping");
}

void rl_yaml_key(char joined[RL_YAML_KEY_MAX], const char *parent, const char *key)
{
    snprintf(joined, RL_YAML_KEY_MAX, "%.100s%s%.50s", parent, *parent ? "." : "", key);
}

/* The next step of a path: a key or an index. */
static const struct rl_yaml_node *step(const struct rl_yaml_node *node, const char **path)
{
    if (**path == '[') {
        char *end;
        unsigned long index = strtoul(*path + 1, &end, 10);
        *path = *end == ']' ? end + 1 : end;
        return node->kind == RL_YAML_SEQUENCE && index < node->n_children ? &node->child[index] : NULL;
    }
    if (**path == '.')
        ++*path;
    size_t length = strcspn(*path, ".[");
    const char *key = *path;
    *path += length;
    for (size_t i = 0; node->kind == RL_YAML_MAPPING && i < node->n_children; i++)
        if (strlen(node->child[i].key) == length && memcmp(node->child[i].key, key, length) == 0)
            return &node->child[i];
    return NULL;
}

/* The deepest node on the way to `key`; *whole says whether it is the one asked for. */
static const struct rl_yaml_node *walk(const struct rl_yaml_tree *tree, const char *key, bool *whole)
{
    const struct rl_yaml_node *node = &tree->root;
    while (*key) {
        const struct rl_yaml_node *next = step(node, &key);
        if (!next) {
            *whole = false;
            return node;
        }
        node = next;
    }
    *whole = true;
    return node;
}

const struct rl_yaml_node *rl_yaml_find(const struct rl_yaml_tree *tree, const char *key)
{
    bool whole;
    const struct rl_yaml_node *node = walk(tree, key, &whole);
    return whole ? node : NULL;
}

int rl_yaml_fail(const struct rl_yaml_tree *tree, struct rl_error *error, const char *key, const char *format,
                 ...)
{
    char message[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    bool whole;
    int line = walk(tree, key, &whole)->line;
    return rl_fail(error, RL_ERR_INPUT, "%.300s:%d: %.160s: %s", tree->path, line, *key ? key : "scene",
                   message);
}

int rl_yaml_fail_value(const struct rl_yaml_tree *tree, struct rl_error *error, const char *key,
                       const char *format, ...)
{
    char expected[400], found[128];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(expected, sizeof expected, format, arguments);
    va_end(arguments);
    rl_yaml_describe(found, sizeof found, rl_yaml_find(tree, key));
    return rl_yaml_fail(tree, error, key, "found %s, expected %s", found, expected);
}

/* ---- Parsing ---- */

static int fail_line(const struct reader *r, size_t line, const char *found, const char *expected)
{
    return rl_fail(r->error, RL_ERR_INPUT, "%.300s:%zu: YAML: found %s, expected %s", r->path, line, found,
                   expected);
}

static int fail_syntax(const struct reader *r)
{
    const yaml_parser_t *p = &r->parser;
    if (p->error == YAML_MEMORY_ERROR)
        return rl_fail_memory(r->error, r->path);
    size_t line = p->problem_mark.line + 1;
    if (p->error == YAML_READER_ERROR) {
        line = 1;
        for (size_t i = 0; i < p->problem_offset && i < r->size; i++)
            line += r->text[i] == '\n';
    }
    char found[200];
    snprintf(found, sizeof found, "a syntax error (%s)",
             p->problem ? p->problem : "no further word from libyaml");
    return fail_line(r, line, found, "a valid document");
}

static int next_event(struct reader *r, yaml_event_t *event)
{
    return yaml_parser_parse(&r->parser, event) ? RL_OK : fail_syntax(r);
}

static int read_value(struct reader *r, struct rl_yaml_node *node, const yaml_event_t *start, int depth);

static struct rl_yaml_node *add_child(struct rl_yaml_node *parent)
{
    size_t n = parent->n_children;
    if ((n & (n - 1)) == 0) { /* full at every power of two */
        struct rl_yaml_node *grown = realloc(parent->child, (n ? 2 * n : 1) * sizeof *grown);
        if (!grown)
            return NULL;
        parent->child = grown;
    }
    parent->child[n] = (struct rl_yaml_node){0};
    parent->n_children++;
    return &parent->child[n];
}

static int read_key(struct reader *r, const struct rl_yaml_node *parent, struct rl_yaml_node *child,
                    yaml_event_t *event)
{
    if (event->type != YAML_SCALAR_EVENT)
        return fail_line(r, event->start_mark.line + 1, "a key that is no word", "plain keys");
    if (parent->n_children > RL_YAML_KEYS_MAX) /* which also bounds the search for doubles below */
        return fail_line(r, event->start_mark.line + 1, "a mapping of more than 64 keys", "a scene");
    child->key = strdup((const char *)event->data.scalar.value);
    if (!child->key)
        return rl_fail_memory(r->error, r->path);
    for (const struct rl_yaml_node *other = parent->child; other < child; other++)
        if (strcmp(other->key, child->key) == 0) {
            char words[128], found[200];
            quote(words, sizeof words, child->key);
            snprintf(found, sizeof found, "the key %s again (first in line %d)", words, other->line);
            return fail_line(r, event->start_mark.line + 1, found, "each key once");
        }
    yaml_event_delete(event);
    return next_event(r, event);
}

/* Reads entries up to the end event of the sequence or mapping. */
static int read_children(struct reader *r, struct rl_yaml_node *node, int depth)
{
    yaml_event_type_t end = node->kind == RL_YAML_MAPPING ? YAML_MAPPING_END_EVENT : YAML_SEQUENCE_END_EVENT;
    for (;;) {
        yaml_event_t event;
        int status = next_event(r, &event);
        if (status != RL_OK)
            return status;
        if (event.type == end) {
            yaml_event_delete(&event);
            return RL_OK;
        }
        int line = (int)event.start_mark.line + 1;
        struct rl_yaml_node *child = add_child(node);
        if (!child) {
            status = rl_fail_memory(r->error, r->path);
        } else {
            child->line = line;
            if (node->kind == RL_YAML_MAPPING)
                status = read_key(r, node, child, &event);
            if (status == RL_OK)
                status = read_value(r, child, &event, depth);
        }
        yaml_event_delete(&event);
        if (status != RL_OK)
            return status;
    }
}

static int read_value(struct reader *r, struct rl_yaml_node *node, const yaml_event_t *start, int depth)
{
    size_t line = start->start_mark.line + 1;
    if (depth > RL_YAML_DEPTH_MAX)
        return fail_line(r, line, "lists or mappings more than 16 levels deep", "a scene");
    switch (start->type) {
    case YAML_SCALAR_EVENT:
        node->kind = RL_YAML_SCALAR;
        node->text = strdup((const char *)start->data.scalar.value);
        if (!node->text)
            return rl_fail_memory(r->error, r->path);
        if (strlen(node->text) != start->data.scalar.length)
            return fail_line(r, line, "a NUL character", "text");
        return RL_OK;
    case YAML_SEQUENCE_START_EVENT:
        node->kind = RL_YAML_SEQUENCE;
        return read_children(r, node, depth + 1);
    case YAML_MAPPING_START_EVENT:
        node->kind = RL_YAML_MAPPING;
        return read_children(r, node, depth + 1);
    default:
        return fail_line(r, line, "an alias", "values written out");
    }
}

/* Skips to the first value of the stream. */
static int read_document(struct reader *r, struct rl_yaml_node *root)
{
    yaml_event_t event;
    int status;
    do {
        status = next_event(r, &event);
        if (status != RL_OK)
            return status;
        yaml_event_type_t type = event.type;
        size_t line = event.start_mark.line + 1;
        if (type == YAML_STREAM_START_EVENT || type == YAML_DOCUMENT_START_EVENT) {
            yaml_event_delete(&event);
            continue;
        }
        if (type == YAML_STREAM_END_EVENT) {
            status = fail_line(r, line, "an empty file", "a scene");
        } else {
            root->line = (int)line;
            status = read_value(r, root, &event, 0);
        }
        yaml_event_delete(&event);
        break;
    } while (true);
    return status;
}

static int read_end(struct reader *r)
{
    yaml_event_type_t type = YAML_NO_EVENT;
    while (type != YAML_STREAM_END_EVENT) {
        yaml_event_t event;
        int status = next_event(r, &event);
        if (status != RL_OK)
            return status;
        type = event.type;
        size_t line = event.start_mark.line + 1;
        yaml_event_delete(&event);
        if (type == YAML_DOCUMENT_START_EVENT)
            return fail_line(r, line, "a second document", "one");
    }
    return RL_OK;
}

int rl_yaml_parse(struct rl_yaml_tree *tree, const char *path, const char *text, size_t size,
                  struct rl_error *error)
{
    *tree = (struct rl_yaml_tree){.path = path};
    struct reader r = {.path = path, .text = text, .size = size, .error = error};
    if (size > RL_YAML_BYTES_MAX) {
        char found[64];
        snprintf(found, sizeof found, "a file of %zu bytes", size);
        return fail_line(&r, 1, found, "a scene of at most 4 MiB");
    }
    if (!yaml_parser_initialize(&r.parser))
        return rl_fail_memory(error, path);
    yaml_parser_set_input_string(&r.parser, (const unsigned char *)text, size);
    int status = read_document(&r, &tree->root);
    if (status == RL_OK)
        status = read_end(&r);
    yaml_parser_delete(&r.parser);
    if (status != RL_OK)
        rl_yaml_clear(tree);
    return status;
}

static void clear_node(struct rl_yaml_node *node)
{
    for (size_t i = 0; i < node->n_children; i++)
        clear_node(&node->child[i]);
    free(node->child);
    free(node->key);
    free(node->text);
    *node = (struct rl_yaml_node){0};
}

void rl_yaml_clear(struct rl_yaml_tree *tree)
{
    clear_node(&tree->root);
}
