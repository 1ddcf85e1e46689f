/* How tests of properties say what is not so: the property, as it is written in the test, and all digits of the first input that lacks it.
 * Include after cmocka.h. */
#ifndef RL_TESTS_HARD_PROPERTY_H
#define RL_TESTS_HARD_PROPERTY_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* Half a unit in the last place of a value just above a power of two, relative to it. */
#define ULP (0.5 * DBL_EPSILON)

static inline void require_at(bool holds, const char *what, const double *in, size_t n, const char *file,
                              int line)
{
    if (holds)
        return;
    print_error("not so: %s, at", what);
    for (size_t i = 0; i < n; i++)
        print_error(" %.17g", in[i]);
    print_error("\n");
    _fail(file, line);
}

/* `holds`, of the numbers `in`, which are printed where it does not. */
#define require(holds, in, n) require_at(holds, #holds, in, n, __FILE__, __LINE__)

#endif
