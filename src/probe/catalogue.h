/* A catalogue of hard cases: rows of arguments of one probe with exact answers and bounds, and what a backend makes of them.
 *
 *     struct rl_catalogue c;
 *     rl_catalogue_load(&c, "tests/hard/frame.tsv", &error);
 *     rl_catalogue_evaluate(&c, NULL, results, &error);         c.n_rows x c.probe.n_out numbers; NULL: in C, else on that GPU
 *     rl_catalogue_judge(&verdict, &c, RL_CATALOGUE_CPU, results);
 *     rl_catalogue_free(&c);
 *
 * A file NAME.tsv is of the probe NAME: comments (#), a header and rows, with the arguments, then for each result the columns NAME,
 * NAME_bound, NAME_single and NAME_single_bound, then `why`. tests/hard/exact.c makes these four and says what they are.
 */
#ifndef RL_PROBE_CATALOGUE_H
#define RL_PROBE_CATALOGUE_H

#include "probe/probe.h"

enum rl_catalogue_backend { RL_CATALOGUE_CPU, RL_CATALOGUE_GPU, RL_CATALOGUE_BACKENDS };

struct rl_catalogue_answer {
    long double exact; /* more digits than a double's, so that errors in ulp have fractions */
    double bound;
};

struct rl_catalogue {
    struct rl_probe probe;
    size_t n_rows;
    double *rows;                                                 /* n_rows x probe.n_in */
    struct rl_catalogue_answer (*answers)[RL_CATALOGUE_BACKENDS]; /* n_rows x probe.n_out */
    size_t *line;                                                 /* of each row in the file, from 1 */
    const char **why;                                             /* of each row; points into `text` */
    char *text;
};

/* Of one result of one row. */
struct rl_catalogue_error {
    double error; /* |got - exact| */
    /* The same in units in the last place (of double precision, or of single) of the answer. In single precision answers below 0.1
     * count as 0.1: there the bound is an absolute one. */
    double ulp;
    double share; /* of the bound; infinite where `got` is not finite, or off with a bound of 0 */
    bool
        conditioned; /* the bound is what the arguments' own rounding does to the answer, so that ulp says little */
};

struct rl_catalogue_verdict {
    size_t n_rows, n_failed; /* rows with any result beyond its bound, or not finite */
    double worst_ulp;        /* of the results that are not `conditioned`; infinite if any is not finite */
    double worst_share;
    size_t row, out; /* of the worst share: `row` and result, from 0 */
};

/* RL_ERR_INPUT with file and line: a name that is no probe's, a header or a row that is not as above, an argument out of the probe's
 * range, an answer that is no finite number, no rows at all. RL_ERR_SYSTEM: cannot be read. */
int rl_catalogue_load(struct rl_catalogue *c, const char *path, struct rl_error *error);
void rl_catalogue_free(struct rl_catalogue *c);

/* The probe that a file is of by its name. */
int rl_catalogue_find_probe(struct rl_probe *probe, const char *path, struct rl_error *error);

/* The folder of the catalogue that comes with the program. RL_ERR_UNAVAILABLE: where it was looked for. */
int rl_catalogue_folder(char path[], size_t size, struct rl_error *error);
/* The files of a folder, sorted by name; free each and the array. RL_ERR_INPUT: there is none. */
int rl_catalogue_list(char ***paths, size_t *n, const char *folder, struct rl_error *error);
void rl_catalogue_list_free(char **paths, size_t n);

/* `gpu` NULL: in C. Errors as rl_probe_gpu. */
int rl_catalogue_evaluate(const struct rl_catalogue *c, struct rl_gpu *gpu, double *results,
                          struct rl_error *error);

/* The bound of an answer of that size (|exact|) which its arguments' rounding does not widen. */
double rl_catalogue_plain_bound(enum rl_catalogue_backend backend, double size);

struct rl_catalogue_error rl_catalogue_error_of(const struct rl_catalogue *c,
                                                enum rl_catalogue_backend backend, size_t row, size_t out,
                                                double got);
void rl_catalogue_judge(struct rl_catalogue_verdict *verdict, const struct rl_catalogue *c,
                        enum rl_catalogue_backend backend, const double *results);

#endif
