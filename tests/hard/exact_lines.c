/* Writes the exact highlights into the catalogue of hard lights, tests/hard/lights/lights.tsv (exact_lines.h has the mathematics).
 *
 *     build/tests/hard/exact_lines FILE                 rows without an answer, or whose inputs have changed since
 *     build/tests/hard/exact_lines --all FILE           every row anew: many minutes
 *     build/tests/hard/exact_lines --check FILE         exit 1 where an answer is missing or not of these inputs, or where one of a sample
 *                                                       of rows, computed anew with less effort, differs within its 20 digits
 *     build/tests/hard/exact_lines --converge FILE      every row once more with more bits and a larger rule; prints how far off that is
 *
 * A file: lines of comment (#), a header, rows. An author writes the inputs, as `roughlight integrate` takes them, and why the row is
 * hard, the last column; what stands between them is made here:
 *
 *     value    exact highlight, radiance 1, for the inputs as double precision has them
 *     moved    what all inputs together move it by when each grows by one unit in its last place (0 stays)
 *     inputs   a hash of the inputs that these two are of
 */
#include "exact_lines.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { INPUTS = 7, MADE = 3, COLUMNS = INPUTS + MADE + 1, DIGITS = 25, SAMPLE = 12 };
static const char header[] =
    "rr\tattenuation\tposition\tnormal\tview\tlight\tlight2\tvalue\tmoved\tinputs\twhy";

static const struct exact_effort full = {400, 40, 1e-27}, moving = {160, 14, 1e-18},
                                 sampling = {280, 24, 1e-21}, more = {560, 56, 1e-29};

struct row {
    char *line; /* as it was, cut into fields; of a comment whole */
    char *field[COLUMNS];
    int n_fields;     /* 0: a comment */
    char made[3][64]; /* value, moved, inputs */
};

struct file {
    const char *path;
    struct row *row;
    size_t n;
};

static void stop(const struct file *file, size_t line, const char *found, const char *expected)
{
    fprintf(stderr, "%s:%zu: found %s, expected %s\n", file->path, line, found, expected);
    exit(2);
}

/* ---- Reading ---- */

static void split(const struct file *file, struct row *row, size_t number)
{
    row->line[strcspn(row->line, "\r\n")] = '\0';
    if (row->line[0] == '#' || row->line[0] == '\0')
        return;
    for (char *at = row->line; at;) {
        if (row->n_fields == COLUMNS)
            stop(file, number, "more columns", header);
        row->field[row->n_fields++] = at;
        at = strchr(at, '\t');
        if (at)
            *at++ = '\0';
    }
    if (row->n_fields != INPUTS + 1 && row->n_fields != COLUMNS)
        stop(file, number, "another number of columns", header);
}

static void read_file(struct file *file)
{
    size_t room = 0, capacity = 0;
    FILE *from = fopen(file->path, "r");
    if (!from)
        stop(file, 0, strerror(errno), "a file");
    for (char *line = NULL; getline(&line, &room, from) >= 0; line = NULL) {
        if (file->n == capacity) {
            capacity = 2 * capacity + 64;
            file->row = realloc(file->row, capacity * sizeof *file->row);
            if (!file->row)
                stop(file, file->n, "no memory", "some");
        }
        file->row[file->n] = (struct row){.line = line};
        split(file, &file->row[file->n], file->n + 1);
        file->n++;
    }
    fclose(from);
}

static bool is_row(const struct row *row)
{
    return row->n_fields > 0 && strcmp(row->field[0], "rr") != 0;
}

/* Numbers separated by commas and spaces; returns how many. */
static int take_numbers(mpfr_t out[], int most, const char *text)
{
    int n = 0;
    for (char *end; *text; text = end) {
        double x = strtod(text, &end);
        if (end == text || n == most || !isfinite(x))
            return -1;
        mpfr_set_d(out[n++], x, MPFR_RNDN);
        end += strspn(end, ", ");
    }
    return n;
}

static bool take_scene(struct scene *scene, const struct row *row)
{
    if (take_numbers(&scene->number[0], 1, row->field[0]) != 1)
        return false;
    mpfr_set_ui(scene->number[1], strcmp(row->field[1], "on") == 0, MPFR_RNDN);
    for (int i = 0; i < 3; i++)
        if (take_numbers(&scene->number[2 + 3 * i], 3, row->field[2 + i]) != 3)
            return false;
    scene->n_lights = strcmp(row->field[6], "-") == 0 ? 1 : 2;
    for (int i = 0; i < scene->n_lights; i++) {
        int n = take_numbers(&scene->number[scene_corner(i, 0)], 3 * SCENE_CORNERS, row->field[5 + i]);
        if (n != 9 && n != 12)
            return false;
        scene->n_corners[i] = n / 3;
    }
    return strcmp(row->field[1], "on") == 0 || strcmp(row->field[1], "off") == 0;
}

/* Fowler, Noll and Vo's hash (FNV-1a, 32 bits) of the inputs' text. */
static uint32_t hash(const struct row *row)
{
    uint32_t h = 2166136261U;
    for (int i = 0; i < INPUTS; i++)
        for (const char *c = row->field[i]; c == row->field[i] || c[-1]; c++)
            h = (h ^ (unsigned char)*c) * 16777619U;
    return h;
}

/* ---- Answers ---- */

static void scene_init(struct scene *scene)
{
    for (int i = 0; i < SCENE_NUMBERS; i++)
        mpfr_init2(scene->number[i], 53);
}

static void scene_clear(struct scene *scene)
{
    for (int i = 0; i < SCENE_NUMBERS; i++)
        mpfr_clear(scene->number[i]);
}

/* What each input moves the answer by, upwards, added up. */
static double moves(struct scene *scene)
{
    mpfr_t here, there, kept;
    double sum = 0.0;
    mpfr_inits2(53, here, there, kept, (mpfr_ptr)0);
    scene_highlight(here, scene, &moving);
    for (size_t i = 0; i < SCENE_NUMBERS; i++) {
        size_t light = i < scene_corner(1, 0) ? 0 : 1;
        bool used =
            i != 1 && (i < scene_corner(0, 0) || (light < (size_t)scene->n_lights &&
                                                  i < scene_corner((int)light, scene->n_corners[light])));
        mpfr_ptr x = scene->number[i];
        if (!used || mpfr_zero_p(x))
            continue;
        mpfr_set(kept, x, MPFR_RNDN);
        mpfr_nextabove(x);
        scene_highlight(there, scene, &moving);
        mpfr_set(x, kept, MPFR_RNDN);
        mpfr_sub(there, there, here, MPFR_RNDN);
        sum += fabs(mpfr_get_d(there, MPFR_RNDN));
    }
    mpfr_clears(here, there, kept, (mpfr_ptr)0);
    return sum;
}

static void make_row(struct row *row)
{
    struct scene scene;
    mpfr_t value;
    scene_init(&scene);
    mpfr_init2(value, 53);
    if (take_scene(&scene, row)) {
        scene_highlight(value, &scene, &full);
        mpfr_snprintf(row->made[0], sizeof row->made[0], "%.*Re", DIGITS - 1, value);
        snprintf(row->made[1], sizeof row->made[1], "%.3g", moves(&scene));
        snprintf(row->made[2], sizeof row->made[2], "%08x", (unsigned)hash(row));
    }
    scene_clear(&scene);
    mpfr_clear(value);
    mpfr_free_cache();
}

/* How far the row's answer is off one made with this effort, of its own size. */
static double difference(const struct row *row, const struct exact_effort *effort)
{
    struct scene scene;
    mpfr_t value, stated;
    double off = INFINITY;
    scene_init(&scene);
    mpfr_init2(value, 53);
    mpfr_init2(stated, 256);
    if (take_scene(&scene, row) && mpfr_set_str(stated, row->field[INPUTS], 10, MPFR_RNDN) == 0) {
        scene_highlight(value, &scene, effort);
        mpfr_sub(value, value, stated, MPFR_RNDN);
        if (!mpfr_zero_p(stated))
            mpfr_div(value, value, stated, MPFR_RNDN);
        off = fabs(mpfr_get_d(value, MPFR_RNDN));
    }
    scene_clear(&scene);
    mpfr_clears(value, stated, (mpfr_ptr)0);
    mpfr_free_cache();
    return off;
}

static bool up_to_date(const struct row *row)
{
    return row->n_fields == COLUMNS && strtoul(row->field[INPUTS + 2], NULL, 16) == hash(row);
}

/* ---- What the program does ---- */

static int write_file(const struct file *file)
{
    FILE *to = fopen(file->path, "w");
    if (!to)
        stop(file, 0, strerror(errno), "a file that can be written");
    for (size_t i = 0; i < file->n; i++) {
        const struct row *row = &file->row[i];
        if (row->n_fields == 0) {
            fprintf(to, "%s\n", row->line);
            continue;
        }
        if (!is_row(row)) {
            fprintf(to, "%s\n", header);
            continue;
        }
        for (int j = 0; j < INPUTS; j++)
            fprintf(to, "%s\t", row->field[j]);
        for (int j = 0; j < MADE; j++)
            fprintf(to, "%s\t", row->made[j][0] ? row->made[j] : row->field[INPUTS + j]);
        fprintf(to, "%s\n", row->field[row->n_fields - 1]);
    }
    if (fclose(to) != 0)
        stop(file, 0, strerror(errno), "a file that can be written");
    return 0;
}

static int make_answers(struct file *file, bool all)
{
#pragma omp parallel for schedule(dynamic)
    for (size_t i = 0; i < file->n; i++)
        if (is_row(&file->row[i]) && (all || !up_to_date(&file->row[i])))
            make_row(&file->row[i]);
    for (size_t i = 0; i < file->n; i++)
        if (is_row(&file->row[i]) && !up_to_date(&file->row[i]) && !file->row[i].made[0][0])
            stop(file, i + 1, "other inputs", header);
    return write_file(file);
}

/* Every SAMPLE-th row, or all of them. */
static int compare_answers(const struct file *file, const struct exact_effort *effort, size_t every,
                           double allowed)
{
    int status = 0;
    double worst = 0.0;
#pragma omp parallel for schedule(dynamic) reduction(max : worst, status)
    for (size_t i = 0; i < file->n; i++) {
        const struct row *row = &file->row[i];
        if (!is_row(row))
            continue;
        bool fresh = up_to_date(row);
        double off = fresh && i % every == 0 ? difference(row, effort) : 0.0;
        worst = fmax(worst, off);
        if (!fresh || !(off <= allowed)) {
            fprintf(stderr,
                    "%s:%zu: the answer is %s (relative difference %.3g); `make hard-answers` writes it\n",
                    file->path, i + 1, fresh ? "another" : "not of these inputs", off);
            status = 1;
        }
    }
    printf("%zu rows at most, greatest relative difference %.3g\n", (file->n + every - 1) / every, worst);
    return status;
}

int main(int argc, char **argv)
{
    struct file file = {.path = argv[argc - 1]};
    const char *mode = argc == 3 ? argv[1] : "";
    if (argc != 2 && strcmp(mode, "--all") != 0 && strcmp(mode, "--check") != 0 &&
        strcmp(mode, "--converge") != 0) {
        fputs("usage: exact_lines [--all|--check|--converge] tests/hard/lights/lights.tsv\n", stderr);
        return 2;
    }
    read_file(&file);
    int status;
    if (strcmp(mode, "--check") == 0)
        status = compare_answers(&file, &sampling, SAMPLE, 1e-20);
    else if (strcmp(mode, "--converge") == 0)
        status = compare_answers(&file, &more, 1, 6e-25);
    else
        status = make_answers(&file, strcmp(mode, "--all") == 0);
    for (size_t i = 0; i < file.n; i++)
        free(file.row[i].line);
    free(file.row);
    return status;
}
