/* Writes the glue of programs (see glue.h): rl_effects_shade in GLSL, with just the loops and calls of one material. */
#include "gpu/glue.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

static void call(FILE *out, const char *what, const struct rl_effect *effect, const char *arguments)
{
    char name[32];
    rl_effect_identifier(name, effect);
    fprintf(out, "%s_%s(%s%s%s_params)", what, name, arguments, *arguments ? ", " : "", name);
}

/* `gives`: of which effects, enum rl_effect_gives. */
static void write_uniforms(FILE *out, const struct rl_plan_material *m, unsigned gives)
{
    for (size_t i = 0; i < m->n_effects; i++) {
        char name[32];
        if (!(gives & rl_effect_gives(m->effect[i])))
            continue;
        rl_effect_identifier(name, m->effect[i]);
        fprintf(out, "uniform vec4 %s_params[%d];\n", name, m->effect[i]->n_params);
    }
}

static void write_factor(FILE *out, const struct rl_plan_material *m)
{
    write_uniforms(out, m, RL_GIVES_FACTOR);
    fprintf(out, "vec3 highlight_factor(Surface s)\n{\n    return vec3(1.0)");
    for (size_t i = 0; i < m->n_effects; i++)
        if (m->effect[i]->factor) {
            fprintf(out, " * ");
            call(out, "factor", m->effect[i], "s");
        }
    fprintf(out, ";\n}\n");
}

/* for each light from `first` to before `end`: rgb += irradiance (reflect_A + reflect_B + ...) */
static void write_incident(FILE *out, const struct rl_plan_material *m, unsigned sees, const char *first,
                           const char *end, const char *from)
{
    fprintf(out,
            "    for (int i = %s; i < %s; i++) {\n        Incident light = %s(i, s.P);\n"
            "        rgb += light.irradiance * (vec3(0.0)",
            first, end, from);
    for (size_t i = 0; i < m->n_effects; i++)
        if (m->effect[i]->reflect && m->effect[i]->sees & sees) {
            fprintf(out, " + ");
            call(out, "reflect", m->effect[i], "s, light.L");
        }
    fprintf(out, ");\n    }\n");
}

static void write_areas(FILE *out, const struct rl_plan_material *m)
{
    if (!(m->sees & RL_SEES_POLYGONS))
        return;
    fprintf(out, "    for (int i = 0; i < N_POLYGONS; i++) {\n        Polygon light = polygons[i];\n");
    for (size_t i = 0; i < m->n_effects; i++)
        if (m->effect[i]->area) {
            fprintf(out, "        rgb += light.radiance.rgb * ");
            call(out, "area", m->effect[i], "s, light.range.x, light.range.y");
            fprintf(out, ";\n");
        }
    fprintf(out, "    }\n");
}

static void write_constants(FILE *out, const struct rl_plan_material *m)
{
    fprintf(out, "    vec3 rgb = vec3(0.0);\n");
    for (size_t i = 0; i < m->n_effects; i++)
        if (m->effect[i]->constant) {
            fprintf(out, "    rgb += ");
            call(out, "constant", m->effect[i], "");
            fprintf(out, ";\n");
        }
}

static void write_lights(FILE *out, const struct rl_plan_material *m)
{
    if (m->n_points > 0)
        write_incident(out, m, RL_SEES_SOURCES, "0", "N_POINTS", "from_point");
    if (m->n_parallels > 0)
        write_incident(out, m, RL_SEES_SOURCES, "N_POINTS", "N_SOURCES", "from_parallel");
    if (m->sees & RL_SEES_CENTROIDS)
        write_incident(out, m, RL_SEES_CENTROIDS, "0", "N_LIGHTS", "from_centroid");
    write_areas(out, m);
}

/* The sum's end. */
static void write_return(FILE *out, const struct rl_plan_material *m)
{
    bool negative = false;
    for (size_t i = 0; i < m->n_effects; i++)
        negative = negative || m->effect[i]->negative;
    fprintf(out, "    return %s;\n}\n", negative ? "positive_zero(rgb)" : "rgb");
}

static bool has_fused_highlight(const struct rl_plan_material *m)
{
    return m->method && m->highlight_program < 0;
}

static void write_surface(FILE *out, const struct rl_plan_material *m)
{
    bool fused = has_fused_highlight(m);
    write_uniforms(out, m, RL_GIVES_CONSTANT | RL_GIVES_REFLECTED);
    fprintf(out, "vec3 shade_effects(Surface s)\n{\n");
    write_constants(out, m);
    write_lights(out, m);
    write_return(out, m);
    if (fused)
        write_factor(out, m);
    fprintf(out, "vec3 shade_highlight(Surface s)\n{\n    return %s;\n}\n",
            fused ? "highlight(s) * highlight_factor(s)" : "vec3(0.0)");
}

/* Of a surface that is interpolated: what depends on the point, for the vertex shader. */
static void write_at_vertices(FILE *out, const struct rl_plan_material *m)
{
    write_uniforms(out, m, RL_GIVES_REFLECTED);
    fprintf(out, "vec3 shade_lights(Surface s)\n{\n    vec3 rgb = vec3(0.0);\n");
    write_lights(out, m);
    write_return(out, m);
}

/* And what does not, for the fragment shader: even a constant varying changes a little on its way through the interpolation. */
static void write_at_pixels(FILE *out, const struct rl_plan_material *m)
{
    write_uniforms(out, m, RL_GIVES_CONSTANT);
    fprintf(out, "vec3 shade_constants()\n{\n");
    write_constants(out, m);
    fprintf(out, "    return rgb;\n}\n");
    if (has_fused_highlight(m))
        write_factor(out, m);
}

static int write(char **text, void (*part)(FILE *, const struct rl_plan_material *),
                 const struct rl_plan_material *m, struct rl_error *error)
{
    size_t size = 0;
    FILE *out = open_memstream(text, &size);
    if (!out)
        return rl_fail_memory(error, "a shader");
    part(out, m);
    if (fclose(out) == 0)
        return RL_OK;
    free(*text);
    *text = NULL;
    return rl_fail_memory(error, "a shader");
}

int rl_glue_make(struct rl_glue *glue, const struct rl_plan_material *m, int program, struct rl_error *error)
{
    *glue = (struct rl_glue){0};
    if (program == m->surface_program && m->interpolation == RL_INTERPOLATION_PHONG)
        return write(&glue->fragment, write_surface, m, error);
    if (program == m->surface_program) {
        int status = write(&glue->vertex, write_at_vertices, m, error);
        return status == RL_OK ? write(&glue->fragment, write_at_pixels, m, error) : status;
    }
    return program == m->highlight_program ? write(&glue->fragment, write_factor, m, error) : RL_OK;
}

void rl_glue_clear(struct rl_glue *glue)
{
    free(glue->vertex);
    free(glue->fragment);
    *glue = (struct rl_glue){0};
}
