/* Compiles the plan's programs and writes the glue that joins their modules. */
#include "gpu/program.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "gpu/glue.h"
#include "gpu/modules.h"

enum { PROGRAM_BYTES = 1 << 20 };

unsigned rl_normal_map_step(int size)
{
    double texels = (double)size * (double)size;
    return (unsigned)(0.6180339887498949 * texels) | 1u;
}

static bool uses(const struct rl_plan_material *m, int index)
{
    return m->surface_program == index || m->highlight_program == index || m->sphere_program == index;
}

/* Whose effects and method the program carries out. The plan gives a program to several materials only where
 * its modules are the same for all, so that any of them will do. */
static const struct rl_plan_material *find_material(const struct rl_plan *plan, int index)
{
    for (size_t i = 0; i < plan->n_materials; i++)
        if (uses(&plan->material[i], index))
            return &plan->material[i];
    return NULL;
}

/* Constants of the plan, so that loops have constant bounds. */
static int write_defines(char **text, const struct rl_plan *plan, const struct rl_plan_program *program,
                         const struct rl_scene *scene, struct rl_error *error)
{
    int n = asprintf(text,
                     "#define N_LIGHTS %zu\n#define N_POINTS %zu\n#define N_SOURCES %zu\n#define N_POLYGONS "
                     "%zu\n#define SAMPLES %d\n"
                     "#define NORMAL_MAP_SIZE %d\n#define NORMAL_MAP_STEP %uu\n",
                     plan->n_lights, plan->n_points, plan->n_sources, rl_plan_polygons(plan, scene),
                     program->samples, plan->settings.normal_size,
                     rl_normal_map_step(plan->settings.normal_size));
    if (n < 0) {
        *text = NULL;
        return rl_fail_memory(error, "a shader");
    }
    return RL_OK;
}

static int compile(GLuint *out, struct rl_gl *gl, GLenum stage, const char *source,
                   const struct rl_plan_program *program, struct rl_error *error)
{
    GLuint shader = gl->CreateShader(stage);
    GLint compiled = 0;
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) {
        char log[4096] = "";
        gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
        gl->DeleteShader(shader);
        return rl_modules_fail(program, log, error);
    }
    *out = shader;
    return RL_OK;
}

/* `second` may be 0. */
static int link_shaders(struct rl_gl *gl, GLuint id, GLuint first, GLuint second,
                        const struct rl_plan_program *program, struct rl_error *error)
{
    GLint linked = 0;
    gl->AttachShader(id, first);
    if (second)
        gl->AttachShader(id, second);
    gl->LinkProgram(id);
    gl->GetProgramiv(id, GL_LINK_STATUS, &linked);
    if (linked)
        return RL_OK;
    char log[4096] = "";
    gl->GetProgramInfoLog(id, sizeof log, NULL, log);
    return rl_modules_fail(program, log, error);
}

static void find_uniforms(struct rl_gpu_program *p, const struct rl_gl *gl)
{
    p->clip_from_world = gl->GetUniformLocation(p->id, "clip_from_world");
    p->eye = gl->GetUniformLocation(p->id, "eye");
    p->specular = gl->GetUniformLocation(p->id, "specular");
    p->sphere_scale = gl->GetUniformLocation(p->id, "sphere_scale");
    p->seen_from = gl->GetUniformLocation(p->id, "seen_from");
    p->environment_unit = gl->GetUniformLocation(p->id, "environment_unit");
    p->face = gl->GetUniformLocation(p->id, "face");
    p->centre = gl->GetUniformLocation(p->id, "centre");
    p->near_plane = gl->GetUniformLocation(p->id, "near_plane");
    const struct rl_plan_material *m = p->material;
    char name[128];
    for (size_t row = 0; row < rl_n_effects; row++) {
        char identifier[32];
        rl_effect_identifier(identifier, rl_effects[row]);
        snprintf(name, sizeof name, "%s_params", identifier);
        p->effect_params[row] = gl->GetUniformLocation(p->id, name);
    }
    p->method_params = -1;
    if (m && m->method) {
        snprintf(name, sizeof name, "%s_params", m->method->name);
        p->method_params = gl->GetUniformLocation(p->id, name);
    }
}

/* A program's two texts, and of how many modules they are. free() the texts. */
struct texts {
    char *vertex, *fragment;
    size_t n_modules;
};

/* Of the modules from `first` to before `end`. */
static int assemble_stage(char **text, struct texts *texts, const struct rl_plan_program *program,
                          size_t first, size_t end, const char *defines, const char *glue,
                          struct rl_error *error)
{
    int status = rl_modules_assemble(text, program, first, end, defines, glue, error);
    if (status == RL_OK)
        texts->n_modules += end - first;
    return status;
}

static int assemble(struct texts *texts, const struct rl_plan_program *program, const char *defines,
                    const struct rl_glue *glue, struct rl_error *error)
{
    size_t n = program->n_vertex;
    int status = assemble_stage(&texts->vertex, texts, program, 0, n, defines, glue->vertex, error);
    if (status == RL_OK)
        status = assemble_stage(&texts->fragment, texts, program, n, program->n_modules, defines,
                                glue->fragment, error);
    return status;
}

static int compile_and_link(GLuint *id, struct rl_gl *gl, const struct rl_plan_program *program,
                            const struct texts *texts, struct rl_error *error)
{
    GLuint vertex = 0;
    GLuint fragment = 0;
    *id = gl->CreateProgram();
    int status = compile(&vertex, gl, GL_VERTEX_SHADER, texts->vertex, program, error);
    if (status == RL_OK)
        status = compile(&fragment, gl, GL_FRAGMENT_SHADER, texts->fragment, program, error);
    if (status == RL_OK)
        status = link_shaders(gl, *id, vertex, fragment, program, error);
    /* Zero is ignored. */
    gl->DeleteShader(vertex);
    gl->DeleteShader(fragment);
    if (status == RL_OK)
        status = rl_gl_check(gl, "compiling shaders", error);
    if (status != RL_OK) {
        gl->DeleteProgram(*id);
        *id = 0;
    }
    return status;
}

/* Kept by its texts. */
static int find_or_compile(struct rl_gpu_program *p, struct rl_gpu *gpu,
                           const struct rl_plan_program *program, const struct texts *texts,
                           struct rl_error *error)
{
    uint64_t key = rl_hash_bytes(RL_HASH_START, texts->vertex, strlen(texts->vertex) + 1);
    key = rl_hash_bytes(key, texts->fragment, strlen(texts->fragment));
    p->id = rl_kept_take(&gpu->kept, RL_KEPT_PROGRAM, key);
    p->kept = p->id != 0;
    if (p->kept)
        return RL_OK;
    int status = compile_and_link(&p->id, &gpu->gl, program, texts, error);
    return status == RL_OK
               ? rl_kept_add(&gpu->kept, &gpu->gl, RL_KEPT_PROGRAM, key, p->id, (size_t)PROGRAM_BYTES, error)
               : status;
}

/* OpenGL promises storage blocks to fragment and compute shaders alone. */
static int check_storage(const struct rl_gl *gl, const struct rl_plan_program *program,
                         struct rl_error *error)
{
    GLint blocks = 0;
    gl->GetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &blocks);
    for (size_t i = 0; i < program->n_vertex; i++)
        if (strcmp(program->module[i], "common/polygons") == 0 && blocks < 2)
            return rl_fail(
                error, RL_ERR_UNAVAILABLE,
                "polygon lights by their exact irradiance need 2 storage blocks in vertex shaders, "
                "this OpenGL has %d, expected the interpolation phong",
                (int)blocks);
    return RL_OK;
}

int rl_program_make(struct rl_gpu_program *p, struct rl_gpu *gpu, const struct rl_plan *plan, size_t index,
                    const struct rl_scene *scene, struct rl_error *error)
{
    const struct rl_plan_program *program = &plan->program[index];
    char *defines = NULL;
    struct rl_glue glue = {0};
    struct texts texts = {0};
    *p = (struct rl_gpu_program){0};
    p->material = find_material(plan, (int)index);
    int status = check_storage(&gpu->gl, program, error);
    if (status == RL_OK)
        status = write_defines(&defines, plan, program, scene, error);
    if (status == RL_OK && p->material)
        status = rl_glue_make(&glue, p->material, (int)index, error);
    if (status == RL_OK)
        status = assemble(&texts, program, defines, &glue, error);
    if (status == RL_OK)
        status = find_or_compile(p, gpu, program, &texts, error);
    p->n_modules = texts.n_modules;
    if (status == RL_OK)
        find_uniforms(p, &gpu->gl);
    free(texts.vertex);
    free(texts.fragment);
    free(defines);
    rl_glue_clear(&glue);
    return status;
}

int rl_program_make_compute(GLuint *id, struct rl_gl *gl, const struct rl_plan_program *program,
                            const char *defines, const char *glue, struct rl_error *error)
{
    char *source = NULL;
    GLuint shader = 0;
    *id = gl->CreateProgram();
    int status = rl_modules_assemble(&source, program, 0, program->n_modules, defines, glue, error);
    if (status == RL_OK)
        status = compile(&shader, gl, GL_COMPUTE_SHADER, source, program, error);
    if (status == RL_OK)
        status = link_shaders(gl, *id, shader, 0, program, error);
    gl->DeleteShader(shader);
    free(source);
    if (status == RL_OK)
        return rl_gl_check(gl, "compiling a compute shader", error);
    gl->DeleteProgram(*id);
    *id = 0;
    return status;
}

void rl_program_free(struct rl_gpu_program *program, struct rl_gpu *gpu)
{
    rl_kept_release(&gpu->kept, &gpu->gl, RL_KEPT_PROGRAM, program->id);
    program->id = 0;
}
