/* What `roughlight study run --help` and `roughlight study export --help` end with: sweeps and tables, from the studies' descriptors. */
#include <stdio.h>
#include <string.h>

#include "cli/study.h"
#include "studies/report.h"

/* The columns of a table that export writes, wrapped; of one of cases, identity is the last. */
static void print_columns(const char *name, const char *summary, const struct rl_column *column, size_t n,
                          bool cases)
{
    printf("  %s: %s\n     ", name, summary);
    size_t used = 5;
    for (size_t i = 0; i < n; i++) {
        size_t length = strlen(column[i].name) + 1;
        if (used + length > 110) {
            printf("\n     ");
            used = 5;
        }
        printf(" %s", column[i].name);
        used += length;
    }
    printf("%s%s\n", cases ? " " : "", cases ? rl_identity_column : "");
}

static void print_each(const struct rl_table *tables, size_t n)
{
    for (size_t t = 0; t < n; t++)
        print_columns(tables[t].name, tables[t].summary, tables[t].column, tables[t].n_columns, true);
}

void rl_study_print_axes(void)
{
    printf(
        "\nWhat --axis may replace, of which cases, by what. Whatever tells a study's cases apart stays.\n");
    for (size_t i = 0; i < rl_n_studies; i++) {
        const struct rl_sweeps *sweeps = &rl_studies[i]->sweeps;
        printf("\n  %s\n", rl_studies[i]->name);
        for (size_t k = 0; k < sweeps->n; k++) {
            char values[256];
            rl_sweep_values(values, sizeof values, &sweeps->sweep[k]);
            printf("    %-13s%s%s%s%s\n", sweeps->sweep[k].name, values, sweeps->sweep[k].of ? " (of " : "",
                   sweeps->sweep[k].of ? sweeps->sweep[k].of : "", sweeps->sweep[k].of ? ")" : "");
        }
    }
}

void rl_study_print_tables(void)
{
    static const struct rl_column samples[] = {{.name = "study"},  {.name = "scene"}, {.name = "parameters"},
                                               {.name = "series"}, {.name = "index"}, {.name = "value"}};
    static const struct rl_column spent[] = {
        {.name = "study"},       {.name = "scene"},   {.name = "parameters"},  {.name = "measured_s"},
        {.name = "reference_s"}, {.name = "setup_s"}, {.name = "evaluation_s"}};
    static const struct rl_column provenance[] = {
        {.name = "study"},   {.name = "scene"},     {.name = "scene_hash"}, {.name = "grid"},
        {.name = "started"}, {.name = "measured"},  {.name = "version"},    {.name = "commit"},
        {.name = "dirty"},   {.name = "code_hash"}, {.name = "compiler"},   {.name = "cflags"},
        {.name = "cpu"},     {.name = "backend"},   {.name = "renderer"},   {.name = "gl_version"},
        {.name = "os"},      {.name = "threads"}};
    static const struct rl_column claims[] = {{.name = "claim"},  {.name = "verdict"}, {.name = "value"},
                                              {.name = "low"},    {.name = "high"},    {.name = "unit"},
                                              {.name = "study"},  {.name = "command"}, {.name = "scene"},
                                              {.name = "figure"}, {.name = "note"},    {.name = "cases"}};
    printf("\nThe tables; columns are added at times, none is renamed. NAME_low and NAME_high: the "
           "95 %% interval of "
           "NAME.\n_ms, _px: the unit; without: a pure number, of radiance 1 = full scale. nan (JSON: null): "
           "not measured.\n"
           "identity: the case, as `cases` of claims names those that a verdict comes from.\n"
           "studies/README.md says what each is.\n\n");
    for (size_t i = 0; i < rl_n_studies; i++) {
        print_each(rl_studies[i]->tables, rl_studies[i]->n_tables);
        print_each(rl_studies[i]->derived_tables, rl_studies[i]->n_derived_tables);
    }
    print_columns("frame_times", "every raw figure of every case, in the order taken", samples,
                  sizeof samples / sizeof samples[0], true);
    print_columns("spent", "where the time of every group of cases went, by its first case", spent,
                  sizeof spent / sizeof spent[0], false);
    print_columns("provenance", "what measured the cases of each study and scene: program, machine, renderer",
                  provenance, sizeof provenance / sizeof provenance[0], false);
    print_columns("claims", "every claim with its verdict and the command that reproduces it", claims,
                  sizeof claims / sizeof claims[0], false);
}
