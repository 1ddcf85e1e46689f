/* The tree of a document: what is found at a path, on which line, and in what words. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/yaml_tree.h"
#include "support/check.h"

static struct rl_error error;

static const char document[] = "# a comment\n"     /* 1 */
                               "a: 1\n"            /* 2 */
                               "list:\n"           /* 3 */
                               "  - x: [10, 20,\n" /* 4 */
                               "        30]\n"     /* 5 */
                               "  - 'two words'\n" /* 6 */
                               "  - |\n"           /* 7 */
                               "    block\n"       /* 8 */
                               "empty:\n"          /* 9 */
                               "nested: {a: {b: {c: 7}}}\n";

static void test_find(void **state)
{
    (void)state;
    static const struct {
        const char *key;
        int line; /* 0: there is none */
        const char *words;
    } cases[] = {
        {"", 2, "a mapping"},
        {"a", 2, "'1'"},
        {"list", 3, "a list of 3"},
        {"list[0]", 4, "a mapping"},
        {"list[0].x", 4, "a list of 3"},
        {"list[0].x[1]", 4, "'20'"},
        {"list[0].x[2]", 5, "'30'"},
        {"list[1]", 6, "'two words'"},
        {"list[2]", 7, "'block\\x0a'"},
        {"empty", 9, "nothing"},
        {"nested.a.b.c", 10, "'7'"},
        {"b", 0, NULL},
        {"list[3]", 0, NULL},
        {"list.x", 0, NULL},
        {"a[0]", 0, NULL},
        {"a.b", 0, NULL},
        {"nested.a.b.c.d", 0, NULL},
        {"nest", 0, NULL},
        {"nested.", 0, NULL},
    };
    struct rl_yaml_tree tree;
    check_ok(rl_yaml_parse(&tree, "x.yaml", document, sizeof document - 1, &error), &error);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct rl_yaml_node *node = rl_yaml_find(&tree, cases[i].key);
        if (!node) {
            assert_int_equal(cases[i].line, 0);
            continue;
        }
        char words[128];
        rl_yaml_describe(words, sizeof words, node);
        assert_int_equal(node->line, cases[i].line);
        assert_string_equal(words, cases[i].words);
    }
    rl_yaml_clear(&tree);
}

static void test_fail(void **state)
{
    (void)state;
    struct rl_yaml_tree tree;
    check_ok(rl_yaml_parse(&tree, "x.yaml", document, sizeof document - 1, &error), &error);
    check_fails(rl_yaml_fail_value(&tree, &error, "list[0].x[2]", "at most %d", 20), &error, RL_ERR_INPUT,
                "x.yaml:5: list[0].x[2]: found '30', expected at most 20");
    /* What is missing is missed in the line of what should hold it. */
    check_fails(rl_yaml_fail_value(&tree, &error, "list[0].y", "a number"), &error, RL_ERR_INPUT,
                "x.yaml:4: list[0].y: found nothing, expected a number");
    check_fails(rl_yaml_fail(&tree, &error, "", "found %s", "this"), &error, RL_ERR_INPUT,
                "x.yaml:2: scene: found this");
    assert_int_equal(rl_yaml_fail(&tree, NULL, "a", "no one listens"), RL_ERR_INPUT);
    rl_yaml_clear(&tree);
}

/* Long and odd values are cut and escaped. */
static void test_words(void **state)
{
    (void)state;
    static const char text[] = "a: \"0123456789012345678901234567890123456789x\"\n"
                               "b: \"\\e[31m\\r\\n\\x7f\"\n";
    struct rl_yaml_tree tree;
    check_ok(rl_yaml_parse(&tree, "x.yaml", text, sizeof text - 1, &error), &error);
    char words[128], small[12];
    rl_yaml_describe(words, sizeof words, rl_yaml_find(&tree, "a"));
    assert_string_equal(words, "'0123456789012345678901234567890123456789...'");
    rl_yaml_describe(words, sizeof words, rl_yaml_find(&tree, "b"));
    assert_string_equal(words, "'\\x1b[31m\\x0d\\x0a\\x7f'");
    rl_yaml_describe(small, sizeof small, rl_yaml_find(&tree, "a")); /* no room: cut, and ended */
    assert_true(strlen(small) < sizeof small);
    rl_yaml_clear(&tree);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_find),
        cmocka_unit_test(test_fail),
        cmocka_unit_test(test_words),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
