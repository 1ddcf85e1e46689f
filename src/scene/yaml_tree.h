/* A YAML document as a tree that remembers lines, for messages; and the check of a tree against a libcyaml
 * schema.
 *
 * libcyaml fills structs but keeps no lines, reads "1.5" as the integer 1 and "nan" as a number, and takes
 * any word but "false" and a few others for true. So a scene is checked here first, against the same schema,
 * with messages of the form
 *
 *     FILE:LINE: materials[0].rr: found 'smooth', expected a number
 *
 * and what libcyaml then loads holds what the schema says. What the schema ignores is not checked. Keys are spelled as paths: lights[2].polygon[0].
 */
#ifndef RL_SCENE_YAML_TREE_H
#define RL_SCENE_YAML_TREE_H

#include <cyaml/cyaml.h>
#include <stddef.h>

#include "base/error.h"

enum rl_yaml_kind { RL_YAML_SCALAR, RL_YAML_SEQUENCE, RL_YAML_MAPPING };

struct rl_yaml_node {
    enum rl_yaml_kind kind;
    int line;   /* from 1: of the key in a mapping, of the entry in a sequence */
    char *key;  /* in a mapping, else NULL */
    char *text; /* of a scalar, else NULL */
    size_t n_children;
    struct rl_yaml_node *child;
};

struct rl_yaml_tree {
    const char *path; /* of the file, for messages; the caller's */
    struct rl_yaml_node root;
};

enum { RL_YAML_BYTES_MAX = 4 << 20, RL_YAML_DEPTH_MAX = 16, RL_YAML_KEYS_MAX = 64, RL_YAML_KEY_MAX = 160 };

/* Parses one document of at most RL_YAML_BYTES_MAX bytes and RL_YAML_DEPTH_MAX levels, without aliases and
 * without a key twice in a mapping. */
int rl_yaml_parse(struct rl_yaml_tree *tree, const char *path, const char *text, size_t size,
                  struct rl_error *error);
void rl_yaml_clear(struct rl_yaml_tree *tree);

/* "parent.key", or "key" for an empty parent. */
void rl_yaml_key(char joined[RL_YAML_KEY_MAX], const char *parent, const char *key);

/* The node at a path such as "materials[0].rr", or NULL. */
const struct rl_yaml_node *rl_yaml_find(const struct rl_yaml_tree *tree, const char *key);

/* "FILE:LINE: KEY: " and the formatted message, RL_ERR_INPUT. Where the key is not in the file the line is
 * that of the nearest mapping or sequence it would be in. */
int rl_yaml_fail(const struct rl_yaml_tree *tree, struct rl_error *error, const char *key, const char *format,
                 ...) __attribute__((format(printf, 4, 5)));

/* The same with the message "found (what is at the key), expected (...)". */
int rl_yaml_fail_value(const struct rl_yaml_tree *tree, struct rl_error *error, const char *key,
                       const char *format, ...) __attribute__((format(printf, 4, 5)));

/* Whether the tree is what the schema says: keys, kinds of values, numbers of entries. Numbers must be
 * finite. (yaml_check.c) */
int rl_yaml_check(const struct rl_yaml_tree *tree, const cyaml_schema_value_t *schema,
                  struct rl_error *error);

/* What a node holds, in words, on one line of printable characters: "'abc'", "nothing", "a list of 3", "a
 * mapping". */
void rl_yaml_describe(char words[], size_t size, const struct rl_yaml_node *node);

#endif
