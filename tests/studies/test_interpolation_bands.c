/* The bands of the study `interpolation`, measured: they do not depend on the picture's pixels. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "studies/interpolation.h"
#include "studies/judged.h"
#include "support/check.h"

static const struct rl_place alone = {"interpolation", RL_NO_SCENE, "", 0};
static const char *const objects[] = {"sphere", "teapot"};

/* Bands are of the mesh: pictures of any size give the same figures (but for the line, which is half a pixel below the middle) and verdicts. */
static void bands_are_of_no_picture_size(void **state)
{
    (void)state;
    static const struct {
        const char *surface, *interpolation;
    } kinds[] = {{"mesh", "constant"}, {"mesh", "gouraud"}, {"mesh", "phong"}, {"exact", "phong"}};
    static const char *const claims[] = {"half of the surface's own largest slope",
                                         "a tenth of the surface's own largest slope"};
    static const int width[] = {400, 800, 1600};
    static const int mesh[] = {8, 6}, fine[] = {128, 64};
    struct rl_bench bench = {0};
    struct rl_error error;
    for (int o = 0; o < 2; o++) {
        struct rl_claim first[2] = {0};
        for (int w = 0; w < 3; w++) {
            struct rl_run run = {.study = "interpolation", .grid = "default"};
            for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
                struct rl_record *r =
                    rl_run_add(&run, &alone, 0, NULL,
                               "series=bands object=%s light=eye exponent=20 surface=%s tessellation=%d "
                               "interpolation=%s width=%d height=%d",
                               objects[o], kinds[k].surface, k == 3 ? fine[o] : mesh[o],
                               kinds[k].interpolation, width[w], width[w] * 3 / 4);
                check_ok(rl_interpolation_measure_bands(r, &bench, &error), &error);
                r->status = RL_RECORD_OK;
            }
            for (int c = 0; c < 2; c++) {
                char words[96];
                snprintf(words, sizeof words, "%s (%s)", claims[c], objects[o]);
                struct rl_claim found = claim_of("interpolation", &run, words);
                print_message("%d pixels: %s: %.4g, %s\n", width[w], words, found.value,
                              rl_verdict_name(found.verdict));
                first[c] = w == 0 ? found : first[c];
                assert_int_equal(found.verdict, first[c].verdict);
                check_relative(found.value, first[c].value, 0.03);
            }
            rl_run_clear(&run);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bands_are_of_no_picture_size)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
