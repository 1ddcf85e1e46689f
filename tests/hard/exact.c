/* Writes the exact answers and the bounds into the catalogue of hard cases, tests/hard/NAME.tsv.
 *
 *     build/tests/hard/exact tests/hard/frame.tsv ...           each file anew, in place
 *     build/tests/hard/exact --check tests/hard/frame.tsv ...   exit 1 where that would change one
 *     build/tests/hard/exact [--check] --maps tests/hard/maps   the same of all maps (exact_map.c)
 *     build/tests/hard/exact --random tests/hard/frame.tsv N SEED    N random rows of that function to stdout (exact_random.c)
 *
 * A file: lines of comment (#), a header, rows. An author writes the arguments and why the row is hard, the last column; what stands
 * between them is made here, four columns for each result:
 *
 *     NAME           exact answer for the arguments as double precision has them
 *     NAME_bound     how far double precision may be from it
 *     NAME_single    exact answer for the arguments rounded to single precision: directions are scaled by a power of two first, what
 *                    leaves the function's range by that is the last number in it
 *     NAME_single_bound
 *
 * Whole numbers as answers have the bound 0. Else the bound is the greatest of: 8 units in the last place, for single precision 1e-5 of the answer and 1e-6; where the function has a
 * size of its whole, one unit in the last place of that; and, where the argument's own rounding moves the answer by more (a badly
 * conditioned case), twice what all arguments together move it by when each changes by one unit in its last place: the answer is then
 * exact for arguments within two units of those given (Higham, Accuracy and Stability of Numerical Algorithms, section 1.5, calls that
 * mixed stability). A row whose reason begins with "exactly:" has the bound without this last part, for what its arguments as they
 * are shall give: it sees faults that are no worse than such a rounding.
 */
#include "exact.h"
#include "exact_random.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS = 25, FIELDS_MAX = EXACT_IN_MAX + 4 * EXACT_OUT_MAX + 1 };

static const char exactly[] = "exactly:";
static const char *path;
static size_t line_number;

static _Noreturn void stop(const char *found, const char *expected)
{
    fprintf(stderr, "%s:%zu: found %s, expected %s\n", path, line_number, found, expected);
    exit(2);
}

/* ---- Answers ---- */

/* False: one of them is past its precision's largest number. */
static bool print_answers(FILE *to, const struct exact_function *f, const double *row, bool strict)
{
    static const double largest[] = {DBL_MAX, FLT_MAX};
    bool finite = true;
    struct exact_answer a;
    exact_answer_init(&a, f);
    a.strict = strict;
    if (!exact_answer_make(&a, f, row))
        stop("an answer that is not finite", "arguments within the function's range");
    for (size_t k = 0; k < f->n_out; k++)
        for (int p = 0; p < 2; p++) {
            finite =
                finite && isfinite(a.bound[p][k]) && fabs(mpfr_get_d(a.out[p][k], MPFR_RNDN)) <= largest[p];
            mpfr_fprintf(to, "%.*Re\t%.3g\t", DIGITS - 1, a.out[p][k], a.bound[p][k]);
        }
    exact_answer_clear(&a, f);
    return finite;
}

/* ---- Files ---- */

static const struct exact_function *find_function(void)
{
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    size_t length = strcspn(name, ".");
    for (size_t i = 0; i < exact_n_functions; i++)
        if (strlen(exact_functions[i].name) == length && strncmp(exact_functions[i].name, name, length) == 0)
            return &exact_functions[i];
    stop(name, "a name of exact_table.c and .tsv");
}

/* Fields that a line lacks are the line. */
static size_t split(char *field[], char *line)
{
    size_t n = 0;
    for (size_t i = 0; i < FIELDS_MAX; i++)
        field[i] = line;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *at = line; at; n++) {
        if (n == FIELDS_MAX)
            stop("more columns", "arguments, answers and why");
        field[n] = at;
        at = strchr(at, '\t');
        if (at)
            *at++ = '\0';
    }
    return n;
}

static void write_header(FILE *to, const struct exact_function *f, char *field[])
{
    for (size_t i = 0; i < f->n_in; i++)
        fprintf(to, "%s\t", field[i]);
    for (size_t k = 0; k < f->n_out; k++)
        fprintf(to, "%s\t%s_bound\t%s_single\t%s_single_bound\t", f->out[k], f->out[k], f->out[k], f->out[k]);
    fputs("why\n", to);
}

static void read_row(double row[], const struct exact_function *f, char *field[], size_t n)
{
    if (n != f->n_in + 1 && n != f->n_in + 4 * f->n_out + 1)
        stop("another number of columns", "the arguments and why, or these and the answers between them");
    for (size_t i = 0; i < f->n_in; i++) {
        char *end = field[i];
        row[i] = strcmp(field[i], "-") == 0 ? NAN : strtod(field[i], &end);
        if (!isnan(row[i]) && (end == field[i] || *end != '\0' || isinf(row[i])))
            stop(field[i], "a finite number, or - for an argument that is left out");
    }
    if (field[n - 1][0] == '\0')
        stop("nothing", "why the row is hard");
}

static void write_row(FILE *to, const struct exact_function *f, char *field[], size_t n)
{
    double row[EXACT_IN_MAX] = {0.0};
    read_row(row, f, field, n);
    for (size_t i = 0; i < f->n_in; i++)
        fprintf(to, "%s\t", field[i]);
    if (!print_answers(to, f, row, strncmp(field[n - 1], exactly, strlen(exactly)) == 0))
        stop("an answer past the largest number", "arguments whose answers double precision has");
    fprintf(to, "%s\n", field[n - 1]);
}

/* The file as it should be. */
static char *rewrite(FILE *from, size_t *size)
{
    const struct exact_function *f = find_function();
    char *made = NULL, *line = NULL, *field[FIELDS_MAX];
    size_t room = 0;
    bool header = true;
    FILE *to = open_memstream(&made, size);
    if (!to)
        stop("no memory", "some");
    for (line_number = 1; getline(&line, &room, from) >= 0; line_number++) {
        if (line[0] == '#' || line[0] == '\n') {
            fputs(line, to);
            continue;
        }
        size_t n = split(field, line);
        if (header && n <= f->n_in)
            stop("fewer columns", "a header: the arguments' names and why");
        if (header)
            write_header(to, f, field);
        else
            write_row(to, f, field, n);
        header = false;
    }
    free(line);
    if (fclose(to) != 0)
        stop("no memory", "some");
    return made;
}

/* ---- Random rows ---- */

/* All of a file's arguments. */
static double *read_rows(FILE *from, const struct exact_function *f, size_t *n_rows)
{
    double *rows = NULL;
    char *line = NULL, *field[FIELDS_MAX];
    size_t room = 0, n_lines = 0;
    for (line_number = 1; getline(&line, &room, from) >= 0; line_number++) {
        if (line[0] == '#' || line[0] == '\n' || n_lines++ == 0)
            continue;
        rows = realloc(rows, ((n_lines - 1) * f->n_in + EXACT_IN_MAX) * sizeof *rows);
        if (!rows)
            stop("no memory", "some");
        read_row(rows + (n_lines - 2) * f->n_in, f, field, split(field, line));
    }
    if (n_lines < 2)
        stop("no rows", "a header and rows");
    *n_rows = n_lines - 1;
    free(line);
    return rows;
}

/* Whether the arguments' rounding decides which side of a jump it is. */
static bool undecided(const struct exact_function *f, const double *row)
{
    static const int bits[] = {EXACT_DOUBLE, EXACT_SINGLE};
    bool any = false;
    mpfr_t in[EXACT_IN_MAX];
    for (size_t i = 0; i < f->n_in; i++)
        mpfr_init(in[i]);
    for (size_t p = 0; p < 2 && f->undecided; p++) {
        for (size_t i = 0; i < f->n_in; i++)
            exact_argument(in[i], f, i, row[i], bits[p]);
        any = any || f->undecided(in, bits[p]);
    }
    for (size_t i = 0; i < f->n_in; i++)
        mpfr_clear(in[i]);
    return any;
}

/* A row whose answers are numbers in both precisions; `name` is its last column. */
static bool write_random_row(FILE *to, const struct exact_function *f, const double *row, const char *name)
{
    for (size_t i = 0; i < f->n_in; i++)
        isnan(row[i]) ? fputs("-\t", to) : fprintf(to, "%.17g\t", row[i]);
    bool finite = print_answers(to, f, row, false);
    fprintf(to, "%s\n", name);
    return finite;
}

static void write_random(FILE *from, size_t n, uint64_t seed)
{
    const struct exact_function *f = find_function();
    struct exact_draw draw = {.seed = seed};
    size_t n_rows, made = 0;
    char *line = NULL, *field[FIELDS_MAX];
    size_t room = 0;
    double *rows = read_rows(from, f, &n_rows), row[EXACT_IN_MAX];
    rewind(from);
    while (getline(&line, &room, from) >= 0 && (line[0] == '#' || line[0] == '\n'))
        ;
    split(field, line);
    write_header(stdout, f, field);
    while (made < n) {
        char *text = NULL, name[64];
        size_t size;
        exact_random_row(row, &draw, f, rows, n_rows);
        if (undecided(f, row))
            continue;
        snprintf(name, sizeof name, "random row %zu of seed %llu", made + 1, (unsigned long long)seed);
        FILE *to = open_memstream(&text, &size);
        if (!to)
            stop("no memory", "some");
        bool finite = write_random_row(to, f, row, name);
        if (fclose(to) != 0)
            stop("no memory", "some");
        if (finite)
            fputs(text, stdout);
        made += finite;
        free(text);
    }
    free(rows);
    free(line);
}

/* ---- The command ---- */

static bool same_as(FILE *from, const char *made, size_t size)
{
    rewind(from);
    size_t i = 0;
    int c;
    while ((c = getc(from)) != EOF && i < size && (char)c == made[i])
        i++;
    return c == EOF && i == size;
}

/* Writes what was made, or (check) only says where that would change the file. Exit status. */
static int put(char *made, size_t size, bool check)
{
    FILE *from = fopen(path, "r");
    bool same = from && same_as(from, made, size);
    if (from)
        fclose(from);
    if (check && !same) {
        fprintf(stderr, "%s: its answers are not what `make hard-answers` writes\n", path);
    } else if (!same) {
        FILE *to = fopen(path, "w");
        if (!to || fwrite(made, 1, size, to) != size || fclose(to) != 0)
            stop(strerror(errno), "a file that can be written");
        same = true;
    }
    free(made);
    return same ? 0 : 1;
}

static int put_file(bool check)
{
    FILE *from = fopen(path, "r");
    if (!from)
        stop(strerror(errno), "a file");
    size_t size;
    char *made = rewrite(from, &size);
    fclose(from);
    return put(made, size, check);
}

static int put_maps(const char *folder, bool check)
{
    int status = 0;
    for (size_t i = 0; exact_map_name(i); i++) {
        char name[4096], *made = NULL;
        size_t size;
        snprintf(name, sizeof name, "%s/%s.tsv", folder, exact_map_name(i));
        path = name;
        line_number = 0;
        FILE *to = open_memstream(&made, &size);
        if (!to)
            stop("no memory", "some");
        exact_map_write(to, i);
        if (fclose(to) != 0)
            stop("no memory", "some");
        status = put(made, size, check) == 0 ? status : 1;
    }
    return status;
}

int main(int argc, char **argv)
{
    bool check = argc > 1 && strcmp(argv[1], "--check") == 0;
    bool maps = argc > 1 + check && strcmp(argv[1 + check], "--maps") == 0;
    bool random = argc == 5 && strcmp(argv[1], "--random") == 0;
    int status = 0, first = 1 + check + maps;
    if (argc <= first || (!random && argv[first][0] == '-')) {
        fputs("usage: exact [--check] tests/hard/NAME.tsv...\n"
              "       exact [--check] --maps tests/hard/maps\n"
              "       exact --random tests/hard/NAME.tsv N SEED\n",
              stderr);
        return 2;
    }
    mpfr_set_default_prec(EXACT_BITS);
    if (random) {
        path = argv[2];
        FILE *from = fopen(path, "r");
        if (!from)
            stop(strerror(errno), "a file");
        write_random(from, strtoul(argv[3], NULL, 10), strtoull(argv[4], NULL, 10));
        fclose(from);
    }
    for (int i = first; i < argc && !random; i++) {
        path = argv[i];
        line_number = 0;
        int failed = maps ? put_maps(argv[i], check) : put_file(check);
        status = failed ? failed : status;
    }
    mpfr_free_cache();
    return status;
}
