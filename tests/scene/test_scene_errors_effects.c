/* Every way in which a scene file's effects can be wrong. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene/wrong.h"

/* Line 13 is the last of `matt`, line 11 the last of `shiny`. */
static void test_effects(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        AT(13, "    phong: 5", "materials[1].phong: found '5', expected a mapping"),
        AT(13, "    phong: {specular: [1, 1, 1]}",
           "materials[1].phong.exponent: found nothing, expected n of cos^n"),
        {13, 13, "    phong:\n      specular: [1, 1, 1]\n      exponent: 0.5", 15,
         "materials[1].phong.exponent: found '0.5', expected 1 to 1000"},
        AT(13, "    phong: {specular: [1, 1, 2], exponent: 5}",
           "materials[1].phong.specular[2]: found '2', expected 0 to 1"),
        AT(13, "    phong: {specular: 1, exponent: 5}",
           "materials[1].phong.specular: found '1', expected a list of 3"),
        AT(13, "    phong: {gloss: 1}",
           "materials[1].phong: found the unknown key 'gloss', expected specular, grazing or exponent"),
        AT(13, "    blinn: {specular: [1, 1, 1], exponent: 5, grazing: 1.5}",
           "materials[1].blinn.grazing: found '1.5', expected 0 to 1"),
        AT(13, "    cook-torrance: {roughness: 0.1}",
           "materials[1].cook-torrance.reflectance: found nothing, expected the reflectance at normal "),
        AT(13, "    cook-torrance: {roughness: 0.1, n: [1, 1, 1]}",
           "materials[1].cook-torrance.k: found nothing, expected both n and k"),
        AT(13, "    cook-torrance: {roughness: 0.1, k: [1, 1, 1]}",
           "materials[1].cook-torrance.n: found nothing, expected both n and k"),
        AT(13, "    cook-torrance: {roughness: 0.1, k: [1, 1, 1], reflectance: [0, 0, 0]}",
           "materials[1].cook-torrance.reflectance: found a list of 3, expected either the reflectance"),
        AT(13, "    cook-torrance: {roughness: 0.1, reflectance: [0, 0, 0], distribution: ggx}",
           "materials[1].cook-torrance.distribution: found 'ggx', expected beckmann or ellipsoid"),
        AT(13, "    goldman: {diffuse: [0, 0, 0], specular: [0, 0, 0]}",
           "materials[1].goldman.c: found nothing, expected c, or rho-reflect and rho-transmit"),
        AT(13, "    goldman: {diffuse: [0, 0, 0], specular: [0, 0, 0], rho-reflect: 1}",
           "materials[1].goldman.rho-transmit: found nothing, expected both"),
        AT(13, "    goldman: {diffuse: [0, 0, 0], specular: [0, 0, 0], rho-reflect: 1, c: 0}",
           "materials[1].goldman.c: found '0', expected either c, or"),
        AT(13, "    lengyel: {diffuse: [0, 0, 0], specular: [0, 0, 0], monochrome: grey}",
           "materials[1].lengyel.monochrome: found 'grey', expected on, off, true or false"),
        AT(13, "    interpolation: flat",
           "materials[1].interpolation: found 'flat', expected phong, gouraud or constant"),
        /* Two models of one thing. */
        {13, 13, "    diffuse: [1, 1, 1]\n    diffuse-area: [1, 1, 1]", 14,
         "materials[1].diffuse-area: found diffuse and diffuse-area, expected one model of diffuse "},
        AT(13,
           "    blinn: {specular: [1, 1, 1], exponent: 5}\n"
           "    phong: {specular: [1, 1, 1], exponent: 5}",
           "materials[1].blinn: found phong and blinn, expected one model of the highlight of point and "),
        {10, 11,
         "    diffuse: [1, 1, 1]\n    highlight: none\n"
         "    kajiya: {diffuse: [0, 0, 0], specular: [0, 0, 0]}",
         12, "materials[0].kajiya: found diffuse and kajiya, expected one model of diffuse reflection"},
        AT(10, "    kajiya: {diffuse: [0, 0, 0], specular: [0, 0, 0]}",
           "materials[0].kajiya: found the highlight random and kajiya, expected one model of the "
           "highlight "),
        AT(13,
           "    kajiya: {diffuse: [0, 0, 0], specular: [0, 0, 0]}\n"
           "    phong: {specular: [1, 1, 1], exponent: 5}",
           "materials[1].kajiya: found phong and kajiya, expected one model of the highlight of point "),
    };
    CHECK_ALL(table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_effects)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
