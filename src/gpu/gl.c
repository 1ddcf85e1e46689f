/* Fills the table of OpenGL functions and turns OpenGL's errors into ours. */
#include "gpu/gl.h"

#include <stdio.h>
#include <string.h>

static void APIENTRY note_error(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                const GLchar *message, const void *user)
{
    (void)source, (void)id, (void)severity, (void)length;
    /* The table is ours and not const; only the callback's type says so. */
    struct rl_gl *gl = (struct rl_gl *)(uintptr_t)user;
    if (type != GL_DEBUG_TYPE_ERROR || gl->complaint[0])
        return;
    snprintf(gl->complaint, sizeof gl->complaint, "%s", message);
    gl->complaint[strcspn(gl->complaint, "\n")] = '\0';
}

int rl_gl_load(struct rl_gl *gl, const struct rl_gpu_backend *backend, void *state, struct rl_error *error)
{
    memset(gl, 0, sizeof *gl);
#define LOAD(type, name) gl->name = (type)backend->get_function(state, "gl" #name);
    RL_GL_FUNCTIONS(LOAD)
#undef LOAD
    if (!gl->GetIntegerv)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "glGetIntegerv not found");
    GLint major = 0;
    GLint minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major < 4 || (major == 4 && minor < 5))
        return rl_fail(error, RL_ERR_UNAVAILABLE, "OpenGL %d.%d, expected 4.5 or newer", major, minor);
#define CHECK(type, name)                                                                                    \
    if (!gl->name)                                                                                           \
        return rl_fail(error, RL_ERR_UNAVAILABLE, "gl" #name " not found in OpenGL %d.%d", major, minor);
    RL_GL_FUNCTIONS(CHECK)
#undef CHECK
    gl->Enable(GL_DEBUG_OUTPUT);
    gl->Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl->DebugMessageCallback(note_error, gl);
    return rl_gl_check(gl, "setting up OpenGL", error);
}

void rl_gl_renderbuffer(GLuint *buffer, const struct rl_gl *gl, GLenum format, int width, int height,
                        size_t *count)
{
    gl->GenRenderbuffers(1, buffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, *buffer);
    gl->RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    *count += 1;
}

static const char *error_name(GLenum code)
{
    switch (code) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return "an unknown error";
    }
}

int rl_gl_check(struct rl_gl *gl, const char *what, struct rl_error *error)
{
    GLenum first = gl->GetError();
    if (first == GL_NO_ERROR) {
        gl->complaint[0] = '\0';
        return RL_OK;
    }
    /* A lost context would report errors for ever. */
    for (int i = 0; i < 16 && gl->GetError() != GL_NO_ERROR; i++)
        ;
    int status = rl_fail(error, RL_ERR_SYSTEM, "%s: %s%s%s", what, error_name(first),
                         gl->complaint[0] ? ": " : "", gl->complaint);
    gl->complaint[0] = '\0';
    return status;
}

int rl_gl_check_framebuffer(struct rl_gl *gl, const char *what, struct rl_error *error)
{
    int status = rl_gl_check(gl, what, error);
    if (status != RL_OK)
        return status;
    GLenum found = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (found == GL_FRAMEBUFFER_COMPLETE)
        return RL_OK;
    return rl_fail(error, RL_ERR_SYSTEM,
                   "%s: OpenGL cannot draw into this format and size (frame buffer status 0x%04x)", what,
                   found);
}
