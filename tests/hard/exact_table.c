/* The functions with a catalogue. */
#include "exact.h"

#define OF_EFFECT .n_out = 3, .out = {"r", "g", "b"}

const struct exact_function exact_functions[] = {
    {.name = "ellipsoid-pdf", .n_in = 2, .n_out = 1, .out = {"pdf"}, .evaluate = exact_ellipsoid_pdf},
    {.name = "ellipsoid-cdf", .n_in = 2, .n_out = 1, .out = {"u"}, .evaluate = exact_ellipsoid_cdf},
    {.name = "ellipsoid-inverse",
     .n_in = 2,
     .n_out = 3,
     .out = {"delta", "sin_delta", "cos_delta"},
     .evaluate = exact_ellipsoid_inverse},
    {.name = "point-light",
     .n_in = 6,
     .n_out = 4,
     .out = {"lx", "ly", "lz", "e"},
     .evaluate = exact_point_light},
    {.name = "reflectance", .n_in = 3, .n_out = 1, .out = {"f"}, .evaluate = exact_reflectance},

    /* Effects. */
    {.name = "ambient", .n_in = 12, .n_directions = 3, OF_EFFECT, .evaluate = exact_ambient},
    {.name = "diffuse", .n_in = 12, .n_directions = 3, OF_EFFECT, .evaluate = exact_diffuse},
    {.name = "diffuse-area", .n_in = 12, .n_directions = 3, OF_EFFECT, .evaluate = exact_diffuse},
    {.name = "diffuse-area-polygon",
     .n_in = 18,
     .n_directions = 2,
     OF_EFFECT,
     .evaluate = exact_diffuse_area_polygon},
    {.name = "phong", .n_in = 14, .n_directions = 3, OF_EFFECT, .evaluate = exact_phong},
    {.name = "blinn", .n_in = 14, .n_directions = 3, OF_EFFECT, .evaluate = exact_blinn},
    {.name = "fresnel", .n_in = 18, .n_directions = 3, OF_EFFECT, .evaluate = exact_fresnel},
    {.name = "cook-torrance", .n_in = 20, .n_directions = 3, OF_EFFECT, .evaluate = exact_cook_torrance},
    {.name = "kajiya", .n_in = 17, .n_directions = 3, OF_EFFECT, .evaluate = exact_kajiya},
    {.name = "kajiya-printed", .n_in = 17, .n_directions = 3, OF_EFFECT, .evaluate = exact_kajiya_printed},
    {.name = "lengyel", .n_in = 17, .n_directions = 3, OF_EFFECT, .evaluate = exact_lengyel},
    {.name = "goldman", .n_in = 20, .n_directions = 3, OF_EFFECT, .evaluate = exact_goldman},
    {.name = "goldman-printed", .n_in = 20, .n_directions = 3, OF_EFFECT, .evaluate = exact_goldman_printed},

    /* exact_model.c */
    {.name = "frame",
     .n_in = 3,
     .n_out = 6,
     .n_directions = 1,
     .out = {"tx", "ty", "tz", "bx", "by", "bz"},
     .evaluate = exact_frame},
    {.name = "frame-printed",
     .n_in = 3,
     .n_out = 6,
     .n_directions = 1,
     .out = {"tx", "ty", "tz", "bx", "by", "bz"},
     .evaluate = exact_frame_printed},
    {.name = "attenuation", .n_in = 4, .n_out = 1, .out = {"g"}, .evaluate = exact_attenuation},
    {.name = "facets-beckmann", .n_in = 2, .n_out = 1, .out = {"d"}, .evaluate = exact_facets_beckmann},
    {.name = "facets-ellipsoid", .n_in = 2, .n_out = 1, .out = {"d"}, .evaluate = exact_facets_ellipsoid},
    {.name = "angle", .n_in = 2, .n_out = 1, .out = {"angle"}, .evaluate = exact_angle},
    {.name = "reflectance-index", .n_in = 1, .n_out = 1, .out = {"n"}, .evaluate = exact_reflectance_index},
};

const size_t exact_n_functions = sizeof exact_functions / sizeof exact_functions[0];
