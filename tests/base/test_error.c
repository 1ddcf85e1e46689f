/* Errors as values: codes, messages, prefixes, and messages that are too long. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/error.h"

static void test_fail_fills_and_returns(void **state)
{
    (void)state;
    struct rl_error error;
    assert_int_equal(rl_fail(&error, RL_ERR_INPUT, "%s:%d: %s", "a.yaml", 7, "wrong"), RL_ERR_INPUT);
    assert_int_equal(error.status, RL_ERR_INPUT);
    assert_string_equal(error.message, "a.yaml:7: wrong");
    assert_int_equal(rl_fail(NULL, RL_ERR_CHECK, "unseen"), RL_ERR_CHECK);
    assert_int_equal(rl_fail_memory(&error, "a mesh"), RL_ERR_SYSTEM);
    assert_string_equal(error.message, "out of memory for a mesh");
}

static void test_prefix(void **state)
{
    (void)state;
    struct rl_error error;
    rl_error_set(&error, RL_ERR_CANCELLED, "inner %d%%", 5);
    assert_int_equal(rl_fail_prefix(&error, "%s %d", "case", 3), RL_ERR_CANCELLED);
    assert_string_equal(error.message, "case 3: inner 5%");
    assert_int_equal(error.status, RL_ERR_CANCELLED);
    assert_int_equal(rl_fail_prefix(NULL, "case"), RL_ERR_SYSTEM);
}

static void test_long_messages_are_cut(void **state)
{
    (void)state;
    char text[3000];
    memset(text, 'm', sizeof text);
    text[sizeof text - 1] = '\0';
    struct rl_error error;
    rl_error_set(&error, RL_ERR_INPUT, "%s", text);
    assert_int_equal(strlen(error.message), sizeof error.message - 1);

    /* A prefix as long leaves room for the message that says more. */
    rl_error_set(&error, RL_ERR_INPUT, "what happened");
    memset(text, 'p', sizeof text - 1);
    rl_fail_prefix(&error, "%s", text);
    assert_true(strlen(error.message) < sizeof error.message);
    assert_non_null(strstr(error.message, "p: what happened"));
}

/* Whatever is quoted in it: a message is one line, and tells a terminal nothing. */
static void test_messages_are_one_line(void **state)
{
    (void)state;
    struct rl_error error;
    rl_error_set(&error, RL_ERR_INPUT, "found '%s'", "a\nb\tc\033[2J\x7f\001 \303\244");
    assert_string_equal(error.message, "found 'a?b?c?[2J?? \303\244'");
    rl_fail_prefix(&error, "a%sb", "\r\n");
    assert_string_equal(error.message, "a??b: found 'a?b?c?[2J?? \303\244'");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fail_fills_and_returns),
        cmocka_unit_test(test_prefix),
        cmocka_unit_test(test_long_messages_are_cut),
        cmocka_unit_test(test_messages_are_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
