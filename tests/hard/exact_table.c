/* The functions with a catalogue. */
#include "exact.h"

const struct exact_function exact_functions[] = {
    {.name = "ellipsoid-pdf", .n_in = 2, .n_out = 1, .out = {"pdf"}, .evaluate = exact_ellipsoid_pdf},
    {.name = "ellipsoid-cdf", .n_in = 2, .n_out = 1, .out = {"u"}, .evaluate = exact_ellipsoid_cdf},
    {.name = "ellipsoid-inverse",
     .n_in = 2,
     .n_out = 3,
     .out = {"delta", "sin_delta", "cos_delta"},
     .evaluate = exact_ellipsoid_inverse},
};

const size_t exact_n_functions = sizeof exact_functions / sizeof exact_functions[0];
