/* See bare_program.h. */
#include "studies/bare_program.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "gpu/context.h"

enum { TEXT_MAX = 4096 };

struct rl_bare {
    struct rl_gpu *gpu;
    int width, height;
    GLuint framebuffer, colour, depth, vertex_array, vertex_buffer, index_buffer, program;
    GLsizei n_indices;
};

static const char vertex_shader[] = "#version 450 core\n"
                                    "layout(location = 0) in vec3 position;\n"
                                    "layout(location = 1) in vec3 normal;\n"
                                    "uniform mat4 clip_from_world;\n"
                                    "out vec3 P;\n"
                                    "out vec3 N_here;\n"
                                    "void main()\n"
                                    "{\n"
                                    "    P = position;\n"
                                    "    N_here = normal;\n"
                                    "    gl_Position = clip_from_world * vec4(position, 1.0);\n"
                                    "}\n";

/* After the numbers' declarations. A light from below the horizon gives neither part anything. */
static const char fragment_shader[] =
    "in vec3 P;\n"
    "in vec3 N_here;\n"
    "layout(location = 0) out vec4 colour;\n"
    "void main()\n"
    "{\n"
    "    vec3 N = normalize(N_here);\n"
    "    vec3 R = reflect(normalize(P - eye), N);\n"
    "    vec3 d = lamp - P;\n"
    "    float r_r = dot(d, d);\n"
    "    vec3 L = d * inversesqrt(r_r);\n"
    "    vec3 rgb = vec3(0.0);\n"
    "    float n_l = dot(N, L);\n"
    "    if (n_l > 0.0)\n"
    "        rgb = lamp_intensity / r_r * (n_l * k_d + pow(max(dot(R, L), 0.0), exponent) * k_s);\n"
    "    n_l = dot(N, sun);\n"
    "    if (n_l > 0.0)\n"
    "        rgb += sun_irradiance * (n_l * k_d + pow(max(dot(R, sun), 0.0), exponent) * k_s);\n"
    "    colour = vec4(rgb, 1.0);\n"
    "}\n";

/* ---- The scene ---- */

static const struct rl_source *source_of_kind(const struct rl_scene *scene, bool parallel)
{
    for (size_t i = 0; i < scene->n_sources; i++)
        if (scene->source[i].parallel == parallel)
            return &scene->source[i];
    return NULL;
}

int rl_bare_check(const struct rl_scene *scene, struct rl_error *error)
{
    const struct rl_effect *diffuse = rl_effect_find("diffuse"), *phong = rl_effect_find("phong");
    const struct rl_material *m = scene->n_objects == 1 ? &scene->material[scene->object[0].material] : NULL;
    bool one = m && !m->method && rl_effect_wanted(m, diffuse) && rl_effect_wanted(m, phong) &&
               !(rl_effect_given(m, phong)[3] > 0.0);
    for (size_t row = 0; one && row < rl_n_effects; row++)
        one = rl_effects[row] == diffuse || rl_effects[row] == phong || !rl_effect_wanted(m, rl_effects[row]);
    bool lit = scene->n_lights == 0 && scene->n_sources == 2 && source_of_kind(scene, false) &&
               source_of_kind(scene, true);
    return one && lit
               ? RL_OK
               : rl_fail(error, RL_ERR_INPUT,
                         "%s: the bare program is written for one object of diffuse and phong (without "
                         "grazing) under a point light and a parallel light",
                         scene->path ? scene->path : "?");
}

/* The numbers of the shader: names and values. */
struct number {
    const char *name;
    int n; /* components */
    double x[3];
};
enum { N_NUMBERS = 8 };

static void take_numbers(struct number number[N_NUMBERS], const struct rl_scene *scene)
{
    const struct rl_material *m = &scene->material[scene->object[0].material];
    const double *k_d = rl_effect_given(m, rl_effect_find("diffuse"));
    const double *phong = rl_effect_given(m, rl_effect_find("phong"));
    const struct rl_source *lamp = source_of_kind(scene, false), *sun = source_of_kind(scene, true);
    const rl_vec3 eye = scene->camera.position;
    const struct number all[N_NUMBERS] = {
        {"eye", 3, {eye.x, eye.y, eye.z}},
        {"lamp", 3, {lamp->at.x, lamp->at.y, lamp->at.z}},
        {"lamp_intensity", 3, {lamp->strength[0], lamp->strength[1], lamp->strength[2]}},
        {"sun", 3, {sun->at.x, sun->at.y, sun->at.z}},
        {"sun_irradiance", 3, {sun->strength[0], sun->strength[1], sun->strength[2]}},
        {"k_d", 3, {k_d[0] / RL_PI, k_d[1] / RL_PI, k_d[2] / RL_PI}},
        {"k_s", 3, {phong[0], phong[1], phong[2]}},
        {"exponent", 1, {phong[4], 0.0, 0.0}},
    };
    memcpy(number, all, sizeof all);
}

/* ---- The program ---- */

static void write_fragment(char text[TEXT_MAX], const struct number *number, enum rl_bare_numbers numbers)
{
    int n = snprintf(text, TEXT_MAX, "#version 450 core\n");
    for (int i = 0; i < N_NUMBERS; i++) {
        const struct number *x = &number[i];
        const char *type = x->n == 3 ? "vec3" : "float";
        size_t room = (size_t)(TEXT_MAX - n);
        if (numbers == RL_BARE_UNIFORMS)
            n += snprintf(text + n, room, "uniform %s %s;\n", type, x->name);
        else if (x->n == 3)
            n += snprintf(text + n, room, "const vec3 %s = vec3(%.9g, %.9g, %.9g);\n", x->name, x->x[0],
                          x->x[1], x->x[2]);
        else
            n += snprintf(text + n, room, "const float %s = float(%.9g);\n", x->name, x->x[0]);
    }
    snprintf(text + n, (size_t)(TEXT_MAX - n), "%s", fragment_shader);
}

static GLuint compile(const struct rl_gl *gl, GLenum stage, const char *text)
{
    GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, 1, &text, NULL);
    gl->CompileShader(shader);
    return shader;
}

static int make_program(struct rl_bare *b, const struct rl_scene *scene, enum rl_bare_numbers numbers,
                        struct rl_error *error)
{
    const struct rl_gl *gl = &b->gpu->gl;
    struct number number[N_NUMBERS];
    char fragment[TEXT_MAX];
    GLint linked = 0;
    take_numbers(number, scene);
    write_fragment(fragment, number, numbers);
    GLuint first = compile(gl, GL_VERTEX_SHADER, vertex_shader);
    GLuint second = compile(gl, GL_FRAGMENT_SHADER, fragment);
    b->program = gl->CreateProgram();
    gl->AttachShader(b->program, first);
    gl->AttachShader(b->program, second);
    gl->LinkProgram(b->program);
    gl->DeleteShader(first);
    gl->DeleteShader(second);
    gl->GetProgramiv(b->program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[512] = "";
        gl->GetProgramInfoLog(b->program, sizeof log, NULL, log);
        return rl_fail(error, RL_ERR_SYSTEM, "the bare program: %s", log);
    }
    gl->UseProgram(b->program);
    for (int i = 0; i < N_NUMBERS && numbers == RL_BARE_UNIFORMS; i++) {
        GLint at = gl->GetUniformLocation(b->program, number[i].name);
        const double *x = number[i].x;
        if (number[i].n == 3)
            gl->Uniform3f(at, (float)x[0], (float)x[1], (float)x[2]);
        else
            gl->Uniform1f(at, (float)x[0]);
    }
    double matrix[16];
    float single[16];
    rl_camera_matrix(&scene->camera, b->width, b->height, false, matrix);
    for (int i = 0; i < 16; i++)
        single[i] = (float)matrix[i];
    gl->UniformMatrix4fv(gl->GetUniformLocation(b->program, "clip_from_world"), 1, GL_FALSE, single);
    return rl_gl_check(&b->gpu->gl, "the bare program", error);
}

/* ---- Buffers ---- */

static int make_framebuffer(struct rl_bare *b, struct rl_error *error)
{
    const struct rl_gl *gl = &b->gpu->gl;
    gl->GenFramebuffers(1, &b->framebuffer);
    gl->GenRenderbuffers(1, &b->colour);
    gl->GenRenderbuffers(1, &b->depth);
    gl->BindRenderbuffer(GL_RENDERBUFFER, b->colour);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, b->width, b->height);
    gl->BindRenderbuffer(GL_RENDERBUFFER, b->depth);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, b->width, b->height);
    gl->BindFramebuffer(GL_FRAMEBUFFER, b->framebuffer);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, b->colour);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, b->depth);
    return rl_gl_check_framebuffer(&b->gpu->gl, "the bare program's frame buffer", error);
}

static int upload_mesh(struct rl_bare *b, const struct rl_mesh *mesh, struct rl_error *error)
{
    const struct rl_gl *gl = &b->gpu->gl;
    float(*vertex)[6] = malloc(mesh->n_vertices * sizeof *vertex);
    if (!vertex)
        return rl_fail_memory(error, "vertices");
    for (size_t i = 0; i < mesh->n_vertices; i++)
        for (int c = 0; c < 3; c++) {
            vertex[i][c] = mesh->position[i][c];
            vertex[i][3 + c] = mesh->normal[i][c];
        }
    gl->GenVertexArrays(1, &b->vertex_array);
    gl->GenBuffers(1, &b->vertex_buffer);
    gl->GenBuffers(1, &b->index_buffer);
    gl->BindVertexArray(b->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, b->vertex_buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(mesh->n_vertices * sizeof *vertex), vertex, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, b->index_buffer);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(mesh->n_triangles * sizeof *mesh->triangle),
                   mesh->triangle, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof *vertex,
                                (const void *)(i * sizeof(float[3])));
    }
    b->n_indices = (GLsizei)(3 * mesh->n_triangles);
    free(vertex);
    return rl_gl_check(&b->gpu->gl, "the bare program's mesh", error);
}

int rl_bare_make(struct rl_bare **out, struct rl_gpu *gpu, const struct rl_scene *scene, int width,
                 int height, enum rl_bare_numbers numbers, struct rl_error *error)
{
    *out = NULL;
    int status = rl_bare_check(scene, error);
    if (status != RL_OK)
        return status;
    struct rl_bare *b = calloc(1, sizeof *b);
    if (!b)
        return rl_fail_memory(error, "the bare program");
    *b = (struct rl_bare){.gpu = gpu, .width = width, .height = height};
    status = make_framebuffer(b, error);
    if (status == RL_OK)
        status = upload_mesh(b, &scene->object[0].mesh, error);
    if (status == RL_OK)
        status = make_program(b, scene, numbers, error);
    if (status != RL_OK) {
        rl_bare_free(b);
        return status;
    }
    *out = b;
    return RL_OK;
}

void rl_bare_free(struct rl_bare *b)
{
    if (!b)
        return;
    const struct rl_gl *gl = &b->gpu->gl;
    gl->DeleteProgram(b->program);
    gl->DeleteVertexArrays(1, &b->vertex_array);
    gl->DeleteBuffers(1, &b->vertex_buffer);
    gl->DeleteBuffers(1, &b->index_buffer);
    gl->DeleteFramebuffers(1, &b->framebuffer);
    gl->DeleteRenderbuffers(1, &b->colour);
    gl->DeleteRenderbuffers(1, &b->depth);
    free(b);
}

/* Every state that it needs: another scene was drawn before. */
int rl_bare_frame(void *user, double *seconds, struct rl_error *error)
{
    struct rl_bare *b = user;
    const struct rl_gl *gl = &b->gpu->gl;
    double start = rl_clock_seconds();
    gl->BindFramebuffer(GL_FRAMEBUFFER, b->framebuffer);
    gl->Viewport(0, 0, b->width, b->height);
    gl->Disable(GL_BLEND);
    gl->Disable(GL_STENCIL_TEST);
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_CULL_FACE);
    gl->DepthFunc(GL_LESS);
    gl->DepthMask(GL_TRUE);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->UseProgram(b->program);
    gl->BindVertexArray(b->vertex_array);
    gl->DrawElements(GL_TRIANGLES, b->n_indices, GL_UNSIGNED_INT, NULL);
    gl->Finish();
    *seconds = rl_clock_seconds() - start;
    return rl_gl_check(&b->gpu->gl, "a frame of the bare program", error);
}

int rl_bare_read(struct rl_bare *b, struct rl_image *image, struct rl_error *error)
{
    const struct rl_gl *gl = &b->gpu->gl;
    int status = rl_image_allocate(image, b->width, b->height, 4, error);
    if (status != RL_OK)
        return status;
    gl->BindFramebuffer(GL_FRAMEBUFFER, b->framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = 0; y < b->height; y++)
        gl->ReadPixels(0, b->height - 1 - y, b->width, 1, GL_RGBA, GL_FLOAT, rl_image_pixel(image, 0, y));
    status = rl_gl_check(&b->gpu->gl, "reading the bare program's picture", error);
    if (status != RL_OK)
        rl_image_clear(image);
    return status;
}
