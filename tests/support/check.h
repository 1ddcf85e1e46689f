/* Assertions that say what they saw. Include after cmocka.h.
 *
 *     check_ok(rl_image_read(&image, path, &error), &error);
 *     check_near(rl_ellipsoid_pdf(&e, 0.1), 0.4975, 1e-15);
 */
#ifndef RL_TESTS_CHECK_H
#define RL_TESTS_CHECK_H

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/error.h"

static inline void check_ok_at(int status, const struct rl_error *error, const char *file, int line)
{
    if (status == RL_OK)
        return;
    print_error("status %d: %s\n", status, error->message);
    _fail(file, line);
}

/* The call succeeded. */
#define check_ok(status, error) check_ok_at(status, error, __FILE__, __LINE__)

static inline void check_fails_at(int status, const struct rl_error *error, int expected, const char *words,
                                  const char *file, int line)
{
    bool found = status == expected && strstr(error->message, words) && !strpbrk(error->message, "\r\n");
    if (found)
        return;
    print_error("status %d, expected %d; one line with '%s' expected in: %s\n", status, expected, words,
                status ? error->message : "");
    _fail(file, line);
}

/* The call failed with this status and one line that contains these words. */
#define check_fails(status, error, expected, words)                                                          \
    check_fails_at(status, error, expected, words, __FILE__, __LINE__)

static inline void check_near_at(double actual, double expected, double tolerance, const char *file, int line)
{
    if (fabs(actual - expected) <= tolerance)
        return;
    print_error("%.17g, expected %.17g +- %g (off by %g)\n", actual, expected, tolerance, actual - expected);
    _fail(file, line);
}

/* |actual - expected| <= tolerance; neither may be NaN. */
#define check_near(actual, expected, tolerance) check_near_at(actual, expected, tolerance, __FILE__, __LINE__)

/* The same in units of the expected value's own size. */
#define check_relative(actual, expected, tolerance)                                                          \
    check_near_at(actual, expected, (tolerance)*fabs(expected), __FILE__, __LINE__)

#endif
