/* Writes the glue of surface programs (see glue.h): rl_effects_shade in GLSL, with just the loops and calls of one material. */
#include "gpu/glue.h"

#include <stdio.h>
#include <stdlib.h>

static void call(FILE *out, const char *what, const struct rl_effect *effect, const char *arguments)
{
    char name[32];
    rl_effect_identifier(name, effect);
    fprintf(out, "%s_%s(%s, %s_params)", what, name, arguments, name);
}

static void write_uniforms(FILE *out, const struct rl_plan_material *m)
{
    for (size_t i = 0; i < m->n_effects; i++) {
        char name[32];
        rl_effect_identifier(name, m->effect[i]);
        fprintf(out, "uniform vec4 %s_params[%d];\n", name, m->effect[i]->n_params);
    }
}

/* for each light: rgb += irradiance (reflect_A + reflect_B + ...) */
static void write_incident(FILE *out, const struct rl_plan_material *m, unsigned sees, const char *count,
                           const char *from)
{
    if (!(m->sees & sees))
        return;
    fprintf(out,
            "    for (int i = 0; i < %s; i++) {\n        Incident light = %s(i, s.P);\n"
            "        rgb += light.irradiance * (vec3(0.0)",
            count, from);
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

static void write_effects(FILE *out, const struct rl_plan_material *m)
{
    write_uniforms(out, m);
    fprintf(out, "vec3 shade_effects(Surface s)\n{\n    vec3 rgb = vec3(0.0);\n");
    for (size_t i = 0; i < m->n_effects; i++)
        if (m->effect[i]->constant) {
            fprintf(out, "    rgb += ");
            call(out, "constant", m->effect[i], "s");
            fprintf(out, ";\n");
        }
    write_incident(out, m, RL_SEES_SOURCES, "N_SOURCES", "from_source");
    write_incident(out, m, RL_SEES_CENTROIDS, "N_LIGHTS", "from_centroid");
    write_areas(out, m);
    fprintf(out, "    return rgb;\n}\n");
}

int rl_glue_surface(char **text, const struct rl_plan_material *m, struct rl_error *error)
{
    size_t size = 0;
    FILE *out = open_memstream(text, &size);
    if (!out)
        return rl_fail_memory(error, "a shader");
    write_effects(out, m);
    bool fused = m->method && m->highlight_program < 0;
    fprintf(out, "vec3 shade_highlight(Surface s)\n{\n    return %s;\n}\n",
            fused ? "highlight(s)" : "vec3(0.0)");
    if (fclose(out) != 0) {
        free(*text);
        *text = NULL;
        return rl_fail_memory(error, "a shader");
    }
    return RL_OK;
}
