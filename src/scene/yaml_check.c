/* Checks a YAML tree against a libcyaml schema (see yaml_tree.h).
 *
 * Of libcyaml's types it knows those that scenes use: integers, doubles, enumerations, strings, mappings and
 * sequences. */
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/yaml_tree.h"

struct check {
    const struct rl_yaml_tree *tree;
    struct rl_error *error;
};

/* ---- What a schema expects, in words ---- */

static void append(char words[], size_t size, const char *text)
{
    size_t length = strlen(words);
    snprintf(words + length, size - length, "%s", text);
}

static void append_separator(char words[], size_t size, size_t i, size_t n)
{
    append(words, size, i == 0 ? "" : i + 1 == n ? " or " : ", ");
}

static void expect_entries(char words[], size_t size, const cyaml_schema_value_t *schema)
{
    unsigned min = schema->sequence.min, max = schema->sequence.max;
    if (min == max)
        snprintf(words, size, "a list of %u", min);
    else
        snprintf(words, size, "a list of %u to %u", min, max);
}

static void expect(char words[], size_t size, const cyaml_schema_value_t *schema)
{
    words[0] = '\0';
    switch (schema->type) {
    case CYAML_INT:
        snprintf(words, size, "a whole number");
        break;
    case CYAML_UINT:
        snprintf(words, size, "a whole number from 0");
        break;
    case CYAML_FLOAT:
        snprintf(words, size, "a finite number");
        break;
    case CYAML_ENUM:
        for (size_t i = 0; i < schema->enumeration.count; i++) {
            append_separator(words, size, i, schema->enumeration.count);
            append(words, size, schema->enumeration.strings[i].str);
        }
        break;
    case CYAML_MAPPING:
        snprintf(words, size, "a mapping");
        break;
    case CYAML_SEQUENCE:
    case CYAML_SEQUENCE_FIXED:
        expect_entries(words, size, schema);
        break;
    default:
        snprintf(words, size, "a text of %u to %u bytes", schema->string.min, schema->string.max);
    }
}

static void expect_keys(char words[], size_t size, const cyaml_schema_field_t *fields)
{
    size_t n = 0;
    while (fields[n].key)
        n++;
    words[0] = '\0';
    for (size_t i = 0; i < n; i++) {
        append_separator(words, size, i, n);
        append(words, size, fields[i].key);
    }
}

/* ---- Scalars ---- */

static bool is_integer(const char *text, bool is_signed, size_t bytes)
{
    const char *digits = is_signed && (*text == '-' || *text == '+') ? text + 1 : text;
    if (digits[0] == '\0' || digits[strspn(digits, "0123456789")] != '\0')
        return false;
    /* libcyaml takes a leading 0 for octal. */
    if (digits[0] == '0' && digits[1] != '\0')
        return false;
    errno = 0;
    if (!is_signed) {
        unsigned long long value = strtoull(text, NULL, 10);
        return errno == 0 && (bytes == 8 || value >> (8 * bytes) == 0);
    }
    long long value = strtoll(text, NULL, 10), limit = bytes == 8 ? 0 : 1LL << (8 * bytes - 1);
    return errno == 0 && (bytes == 8 || (value >= -limit && value < limit));
}

static bool is_number(const char *text)
{
    char *end;
    if (text[0] == '\0' || text[strspn(text, "+-.0123456789eE")] != '\0')
        return false;
    errno = 0;
    double value = strtod(text, &end);
    return *end == '\0' && isfinite(value) && errno == 0;
}

static bool is_enumerated(const char *text, const cyaml_schema_value_t *schema)
{
    for (size_t i = 0; i < schema->enumeration.count; i++)
        if (strcmp(schema->enumeration.strings[i].str, text) == 0)
            return true;
    return false;
}

static bool is_scalar_of(const char *text, const cyaml_schema_value_t *schema)
{
    switch (schema->type) {
    case CYAML_INT:
        return is_integer(text, true, schema->data_size);
    case CYAML_UINT:
        return is_integer(text, false, schema->data_size);
    case CYAML_FLOAT:
        return is_number(text);
    case CYAML_ENUM:
        return is_enumerated(text, schema);
    default:
        return strlen(text) >= schema->string.min && strlen(text) <= schema->string.max;
    }
}

/* ---- The walk ---- */

static int check_node(const struct check *c, const struct rl_yaml_node *node,
                      const cyaml_schema_value_t *schema, const char *key);

static int fail_type(const struct check *c, const cyaml_schema_value_t *schema, const char *key)
{
    char expected[256];
    expect(expected, sizeof expected, schema);
    return rl_yaml_fail_value(c->tree, c->error, key, "%s", expected);
}

static const cyaml_schema_field_t *find_field(const cyaml_schema_field_t *fields, const char *key)
{
    for (; fields->key; fields++)
        if (strcmp(fields->key, key) == 0)
            return fields;
    return NULL;
}

static bool has_child(const struct rl_yaml_node *node, const char *key)
{
    for (size_t i = 0; i < node->n_children; i++)
        if (strcmp(node->child[i].key, key) == 0)
            return true;
    return false;
}

static int check_mapping(const struct check *c, const struct rl_yaml_node *node,
                         const cyaml_schema_field_t *fields, const char *key)
{
    char path[RL_YAML_KEY_MAX], expected[512];
    for (size_t i = 0; i < node->n_children; i++) {
        const struct rl_yaml_node *child = &node->child[i];
        const cyaml_schema_field_t *field = find_field(fields, child->key);
        if (!field) {
            /* The key itself may be anything: it is quoted, and the place is the mapping's with the key's
             * line. */
            struct rl_yaml_node word = {.kind = RL_YAML_SCALAR, .text = child->key};
            char quoted[128];
            rl_yaml_describe(quoted, sizeof quoted, &word);
            expect_keys(expected, sizeof expected, fields);
            return rl_fail(c->error, RL_ERR_INPUT, "%.300s:%d: %.100s: found the unknown key %s, expected %s",
                           c->tree->path, child->line, *key ? key : "scene", quoted, expected);
        }
        rl_yaml_key(path, key, child->key);
        int status = check_node(c, child, &field->value, path);
        if (status != RL_OK)
            return status;
    }
    for (; fields->key; fields++)
        if (!(fields->value.flags & CYAML_FLAG_OPTIONAL) && !has_child(node, fields->key)) {
            rl_yaml_key(path, key, fields->key);
            return fail_type(c, &fields->value, path);
        }
    return RL_OK;
}

static int check_sequence(const struct check *c, const struct rl_yaml_node *node,
                          const cyaml_schema_value_t *schema, const char *key)
{
    if (node->n_children < schema->sequence.min || node->n_children > schema->sequence.max)
        return fail_type(c, schema, key);
    for (size_t i = 0; i < node->n_children; i++) {
        char path[RL_YAML_KEY_MAX];
        snprintf(path, sizeof path, "%.120s[%zu]", key, i);
        int status = check_node(c, &node->child[i], schema->sequence.entry, path);
        if (status != RL_OK)
            return status;
    }
    return RL_OK;
}

static int check_node(const struct check *c, const struct rl_yaml_node *node,
                      const cyaml_schema_value_t *schema, const char *key)
{
    switch (schema->type) {
    case CYAML_IGNORE: /* the builder reads it from the tree, and says what is wrong with it */
        return RL_OK;
    case CYAML_MAPPING:
        if (node->kind == RL_YAML_MAPPING)
            return check_mapping(c, node, schema->mapping.fields, key);
        break;
    case CYAML_SEQUENCE:
    case CYAML_SEQUENCE_FIXED:
        if (node->kind == RL_YAML_SEQUENCE)
            return check_sequence(c, node, schema, key);
        break;
    default:
        if (node->kind == RL_YAML_SCALAR && is_scalar_of(node->text, schema))
            return RL_OK;
    }
    return fail_type(c, schema, key);
}

int rl_yaml_check(const struct rl_yaml_tree *tree, const cyaml_schema_value_t *schema, struct rl_error *error)
{
    struct check c = {.tree = tree, .error = error};
    return check_node(&c, &tree->root, schema, "");
}
