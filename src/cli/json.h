/* JSON on stdout, value by value: what nests.
 *
 *     rl_json_open(&json, NULL, '{');
 *     rl_json_text(&json, "name", "ball");                      {"name": "ball", "parts": [1, null]}
 *     rl_json_open(&json, "parts", '[');
 *     rl_json_integer(&json, NULL, 1); rl_json_text(&json, NULL, NULL);
 *     rl_json_close(&json, ']'); rl_json_close(&json, '}');
 *
 * `key` is NULL inside of an array. With json NULL nothing is printed, so that who prints TSV as well needs no branch for each value.
 */
#ifndef RL_CLI_JSON_H
#define RL_CLI_JSON_H

#include <stdbool.h>

/* {0} to begin with. */
struct rl_json {
    bool filled; /* something stands before in the innermost bracket: a comma is due */
};

void rl_json_open(struct rl_json *json, const char *key, char bracket);
void rl_json_close(struct rl_json *json, char bracket);

/* NULL is null, and so is a number that is not finite: JSON has none. */
void rl_json_text(struct rl_json *json, const char *key, const char *value);
void rl_json_number(struct rl_json *json, const char *key, double value);
void rl_json_integer(struct rl_json *json, const char *key, long long value);
void rl_json_boolean(struct rl_json *json, const char *key, bool value);

/* The fewest of 15, 16 or 17 digits that read back as the same number, which is finite. */
void rl_print_number(double value);

#endif
