/* `illuminance`: what a scene's lights give at a point, a row each and their sum. */
#include <stdio.h>
#include <stdlib.h>

#include "cli/command.h"
#include "cli/output.h"
#include "model/photometry.h"
#include "scene/irradiance.h"

static const struct rl_option options_illuminance[] = {
    {0, "at", "x,y,z", "the point, in the scene's coordinates; needed"},
    {0, "normal", "x,y,z", "where the surface there faces, any length; needed"},
    {0},
};

static void row(struct rl_rows *rows, const char *light, const char *kind, const double rgb[3],
                bool photometric)
{
    rl_rows_text(rows, light);
    rl_rows_text(rows, kind);
    for (int c = 0; c < 3; c++)
        rl_rows_number(rows, rgb[c]);
    rl_rows_number(rows, rl_luminance(rgb));
    rl_rows_text(rows, photometric ? "lx" : "W/m2");
}

static const char *kind_of(const struct rl_scene *scene, size_t i)
{
    if (i < scene->n_lights)
        return scene->light[i].mesh ? "mesh" : "polygon";
    return scene->source[i - scene->n_lights].parallel ? "parallel" : "point";
}

static void print(const struct rl_scene *scene, double rgb[][3], enum rl_output format)
{
    static const char *const columns[] = {"light", "kind", "red", "green", "blue", "value", "unit", NULL};
    double total[3] = {0.0, 0.0, 0.0};
    bool photometric = scene->white > 0.0;
    struct rl_rows rows;
    rl_rows_begin(&rows, format, columns);
    for (size_t i = 0; i < scene->n_lights + scene->n_sources; i++) {
        const char *name =
            i < scene->n_lights ? scene->light[i].name : scene->source[i - scene->n_lights].name;
        row(&rows, name, kind_of(scene, i), rgb[i], photometric);
        for (int c = 0; c < 3; c++)
            total[c] += rgb[i][c];
    }
    row(&rows, "total", "sum", total, photometric);
    rl_rows_end(&rows);
}

/* Exact of closed, convex meshes and of flat ones; of an open one that bends, where none of its triangles hides another. */
static void warn_of_bent_sheets(const struct rl_scene *scene)
{
    for (size_t i = 0; i < scene->n_lights; i++) {
        const struct rl_light *light = &scene->light[i];
        if (light->mesh && !light->closed && !(v3_length(light->normal) > 0.0))
            fprintf(stderr,
                    "illuminance: warning: the light %s is an open mesh that is not flat, of which every "
                    "triangle counts in full, also where another hides it\n",
                    light->name);
    }
}

static int measure(const struct rl_scene *scene, rl_vec3 P, rl_vec3 N, enum rl_output format,
                   struct rl_error *error)
{
    double(*rgb)[3] = calloc(scene->n_lights + scene->n_sources + 1, sizeof *rgb);
    if (!rgb)
        return rl_fail_memory(error, "the lights");
    int status = rl_scene_irradiance(rgb, scene, P, N, error);
    if (status == RL_ERR_INPUT)
        rl_fail_prefix(error, "--at");
    if (status == RL_OK) {
        warn_of_bent_sheets(scene);
        print(scene, rgb, format);
    }
    free(rgb);
    return status;
}

static int run(const struct rl_arguments *a, struct rl_error *error)
{
    static const char *const needed[] = {"at", "normal"};
    rl_vec3 P, N;
    enum rl_output format;
    struct rl_scene scene;
    for (size_t i = 0; i < sizeof needed / sizeof needed[0]; i++)
        if (!rl_argument(a, needed[i]))
            return rl_exit_of(
                rl_fail(error, RL_ERR_INPUT,
                        "--%s is missing, expected x,y,z; 'roughlight illuminance --help' shows "
                        "an example",
                        needed[i]));
    int status = rl_argument_output(a, &format, error);
    if (status == RL_OK)
        status = rl_argument_vector(a, "at", false, &P, error);
    if (status == RL_OK)
        status = rl_argument_vector(a, "normal", true, &N, error);
    if (status == RL_OK)
        status = rl_scene_load(&scene, a->positional[0], error);
    if (status != RL_OK)
        return rl_exit_of(status);
    status = measure(&scene, P, N, format, error);
    rl_scene_clear(&scene);
    return rl_exit_of(status);
}

const struct rl_command rl_command_illuminance = {
    .name = "illuminance",
    .arguments = "SCENE --at x,y,z --normal x,y,z [--format tsv|json]",
    .min_positionals = 1,
    .max_positionals = 1,
    .summary = "how much light a point of a scene gets, from each light and in all",
    .description =
        "Prints a row for each light and one for all, `total`: light, kind, red, green, blue, value, unit.\n"
        "In a photometric scene (luminance, luminous-intensity, flux or illuminance; lengths in metres) "
        "`value` is the\n"
        "illuminance in lx, and red, green and blue are its parts in linear RGB: 0.2126 red + 0.7152 green + "
        "0.0722 blue =\n"
        "value. In a radiometric scene they are the irradiance in W/m2 of each channel, and value is their "
        "mean with the\n"
        "same weights.\n\n"
        "Polygons are exact, by Lambert's sum over their edges, and what of them is below the surface's "
        "horizon "
        "does not count.\n"
        "A polygon shines from both sides. Closed, convex meshes and flat ones are exact, too. Of other "
        "closed "
        "ones every\n"
        "triangle counts half, of other open ones in full, also where the mesh hides it.\n"
        "There are no shadows, and nothing is reflected: this is the direct light of an empty room, and the "
        "scene's objects do not\n"
        "matter.\n\n"
        "The desk of an office, and how much of its light each lamp and the window give:\n\n"
        "  roughlight illuminance studies/scenes/office.yaml --at 0,0.75,0 --normal 0,1,0\n"
        "  roughlight illuminance studies/scenes/office.yaml --at 0,0.75,0 --normal 0,1,0 --format json",
    .options = (const struct rl_option *const[]){options_illuminance, rl_options_format, NULL},
    .run = run,
};
