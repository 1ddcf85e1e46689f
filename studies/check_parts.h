/* Within studies/check*.c: what the kinds of cases share. */
#ifndef RL_STUDIES_CHECK_PARTS_H
#define RL_STUDIES_CHECK_PARTS_H

#include "image/image.h"
#include "reference/renderer.h"
#include "results/baseline.h"
#include "results/buffer.h"
#include "scene/scene.h"
#include "studies/bench.h"
#include "studies/check.h"

/* A case's rows as they are measured. Once one cannot be added, later ones are not; status says so. */
struct rl_check_rows {
    struct rl_baseline *now;
    struct rl_baseline_row like; /* scene, parameters, provenance */
    struct rl_error *error;
    int status;
};

/* `drawn`: the GPU has a part in it. */
void rl_check_fixed(struct rl_check_rows *rows, const char *metric, enum rl_best best, double value,
                    double tolerance, const char *tolerance_from, bool drawn);
void rl_check_random(struct rl_check_rows *rows, const char *metric, enum rl_best best, const double value[],
                     size_t n, double relevant);

/* References that cases have in common. */
enum { RL_CHECK_TRUTHS_MAX = 32 };

struct rl_check_truth {
    const struct rl_scene *scene;
    double rr;          /* 0: as the scene says */
    const char *method; /* "reference", or one that is a function on the CPU */
    struct rl_image image;
    struct rl_render_stats stats;
};

struct rl_check_truths {
    size_t n;
    struct rl_check_truth truth[RL_CHECK_TRUTHS_MAX];
};

/* What each kind of case may use. */
struct rl_check_context {
    struct rl_bench *bench;
    struct rl_check_truths *truths;
    const struct rl_check_options *options;
    const struct rl_scene *scene; /* NULL: none */
    uint64_t first_seed; /* of this case: cases with the same seeds would be wrong together by chance */
    void **kept;         /* a case's own, from one rl_check_measure to the next; NULL at first */
};

struct rl_check_case {
    const char *scene; /* RL_NO_SCENE, or a shipped one */
    const char *parameters;
    bool random;
    /* Adds the case's rows. */
    int (*measure)(struct rl_check_rows *rows, const struct rl_check_case *c,
                   struct rl_check_context *context);
    /* Frees what was kept. */
    void (*release)(void *kept);
};

extern const struct rl_check_case rl_check_cases[];
extern const size_t rl_n_check_cases;

/* check_model.c: functions of src/model and patterns, by their parameter `function`. */
int rl_check_model(struct rl_check_rows *rows, const struct rl_check_case *c,
                   struct rl_check_context *context);
/* check_points.c: the integrators at the point of the parameter `point`. */
int rl_check_point(struct rl_check_rows *rows, const struct rl_check_case *c,
                   struct rl_check_context *context);
/* check_maps.c: normal maps. */
int rl_check_map(struct rl_check_rows *rows, const struct rl_check_case *c, struct rl_check_context *context);
/* check_rounding.c: what normal maps of the parameter `normal_bits`, or texels of `env_format`, do to values between their steps. */
int rl_check_rounding(struct rl_check_rows *rows, const struct rl_check_case *c,
                      struct rl_check_context *context);
/* check_generators.c: the random numbers of the study `distribution`. */
int rl_check_generator(struct rl_check_rows *rows, const struct rl_check_case *c,
                       struct rl_check_context *context);
/* check_pictures.c: pictures on the GPU, of random and of fixed methods, and the reference's. */
int rl_check_random_picture(struct rl_check_rows *rows, const struct rl_check_case *c,
                            struct rl_check_context *context);
int rl_check_fixed_picture(struct rl_check_rows *rows, const struct rl_check_case *c,
                           struct rl_check_context *context);
int rl_check_reference(struct rl_check_rows *rows, const struct rl_check_case *c,
                       struct rl_check_context *context);
void rl_check_release_picture(void *kept);

#endif
