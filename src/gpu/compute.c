/* Compiles a program of one compute shader, runs it over rows in pieces, reads the results back (see compute.h). */
#include "gpu/compute.h"

#include <stdio.h>
#include <stdlib.h>

#include "gpu/context.h"
#include "gpu/program.h"

/* Rows a work group; as passes/probe.glsl has it. OpenGL grants 65535 groups at once. */
enum { GROUP_ROWS = 64, PIECE_ROWS = 65535 * GROUP_ROWS };

struct buffers {
    GLuint arguments, results;
};

static int run_piece(struct rl_gl *gl, const struct buffers *b, const float *arguments, size_t in_bytes,
                     float *results, size_t out_bytes, size_t n_rows, struct rl_error *error)
{
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, b->arguments);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)in_bytes, arguments, GL_STREAM_DRAW);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, b->results);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)out_bytes, NULL, GL_STREAM_READ);
    gl->DispatchCompute((GLuint)((n_rows + GROUP_ROWS - 1) / GROUP_ROWS), 1, 1);
    gl->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)out_bytes, results);
    return rl_gl_check(gl, "evaluating rows", error);
}

int rl_gpu_compute(struct rl_gpu *gpu, const struct rl_plan_program *program, const char *glue,
                   const float *arguments, size_t n_in, float *results, size_t n_out, size_t n_rows,
                   struct rl_error *error)
{
    struct rl_gl *gl = &gpu->gl;
    struct buffers b = {0};
    GLuint id = 0;
    char defines[128];
    /* An effect's polygon, where it has one, is that of common/one_polygon. */
    snprintf(defines, sizeof defines, "#define N_IN %zu\n#define N_OUT %zu\n#define N_POLYGONS 1\n", n_in,
             n_out);
    int status = rl_program_make_compute(&id, gl, program, defines, glue, error);
    if (status != RL_OK)
        return status;
    gl->GenBuffers(1, &b.arguments);
    gl->GenBuffers(1, &b.results);
    gl->UseProgram(id);
    for (size_t first = 0; first < n_rows && status == RL_OK; first += PIECE_ROWS) {
        size_t n = n_rows - first < PIECE_ROWS ? n_rows - first : PIECE_ROWS;
        status = run_piece(gl, &b, arguments + first * n_in, n * n_in * sizeof *arguments,
                           results + first * n_out, n * n_out * sizeof *results, n, error);
    }
    gl->UseProgram(0);
    gl->DeleteBuffers(1, &b.arguments);
    gl->DeleteBuffers(1, &b.results);
    gl->DeleteProgram(id);
    return status;
}
