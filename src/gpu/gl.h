/* OpenGL 4.5 core as a table of just the functions used here, filled at run time through the backend: no GL
 * library is linked.
 *
 *     const struct rl_gl *gl = &gpu->gl;
 *     gl->BindTexture(GL_TEXTURE_2D, texture);
 *     return rl_gl_check(gl, "the normal map", error);
 *
 * A new function is one row of RL_GL_FUNCTIONS, its type from GL/glcorearb.h.
 */
#ifndef RL_GPU_GL_H
#define RL_GPU_GL_H

#include <stddef.h>

#include <GL/glcorearb.h>

#include "base/error.h"
#include "gpu/backend.h"

/* clang-format off */
#define RL_GL_FUNCTIONS(X)                                         \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                       \
    X(PFNGLATTACHSHADERPROC, AttachShader)                         \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                             \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                     \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                   \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                 \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                           \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                   \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)               \
    X(PFNGLBUFFERDATAPROC, BufferData)                             \
    X(PFNGLBUFFERSUBDATAPROC, BufferSubData)                       \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)     \
    X(PFNGLCLEARPROC, Clear)                                       \
    X(PFNGLCLEARCOLORPROC, ClearColor)                             \
    X(PFNGLCLEARDEPTHPROC, ClearDepth)                             \
    X(PFNGLCLIPCONTROLPROC, ClipControl)                           \
    X(PFNGLCOLORMASKPROC, ColorMask)                               \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                       \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                       \
    X(PFNGLCREATESHADERPROC, CreateShader)                         \
    X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback)         \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                       \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)             \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                       \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)           \
    X(PFNGLDELETESHADERPROC, DeleteShader)                         \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                     \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)             \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                               \
    X(PFNGLDEPTHMASKPROC, DepthMask)                               \
    X(PFNGLDISABLEPROC, Disable)                                   \
    X(PFNGLDISPATCHCOMPUTEPROC, DispatchCompute)                   \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                             \
    X(PFNGLDRAWELEMENTSPROC, DrawElements)                         \
    X(PFNGLENABLEPROC, Enable)                                     \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)   \
    X(PFNGLFINISHPROC, Finish)                                     \
    X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)   \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)         \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                             \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                   \
    X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                 \
    X(PFNGLGENTEXTURESPROC, GenTextures)                           \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                   \
    X(PFNGLGETBUFFERSUBDATAPROC, GetBufferSubData)                 \
    X(PFNGLGETERRORPROC, GetError)                                 \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                           \
    X(PFNGLGETRENDERBUFFERPARAMETERIVPROC, GetRenderbufferParameteriv) \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)               \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                         \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                 \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                           \
    X(PFNGLGETSTRINGPROC, GetString)                               \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)             \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                           \
    X(PFNGLMEMORYBARRIERPROC, MemoryBarrier)                       \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                           \
    X(PFNGLREADPIXELSPROC, ReadPixels)                             \
    X(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)           \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                         \
    X(PFNGLSTENCILFUNCPROC, StencilFunc)                           \
    X(PFNGLSTENCILOPPROC, StencilOp)                               \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                       \
    X(PFNGLTEXSTORAGE2DPROC, TexStorage2D)                         \
    X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                       \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                               \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                               \
    X(PFNGLUNIFORM4FVPROC, Uniform4fv)                             \
    X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)                 \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                 \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                             \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)           \
    X(PFNGLSCISSORPROC, Scissor)                                   \
    X(PFNGLVIEWPORTPROC, Viewport)
/* clang-format on */

struct rl_gl {
#define RL_GL_MEMBER(type, name) type name;
    RL_GL_FUNCTIONS(RL_GL_MEMBER)
#undef RL_GL_MEMBER
    /* The driver's own words on the first error since the last check; written by a callback inside of GL
     * calls. */
    char complaint[256];
};

/* Fills the table from a backend whose context is current. RL_ERR_UNAVAILABLE if it is older than OpenGL 4.5.
 */
int rl_gl_load(struct rl_gl *gl, const struct rl_gpu_backend *backend, void *state, struct rl_error *error);

/* Makes a render buffer and adds one to *count. */
void rl_gl_renderbuffer(GLuint *buffer, const struct rl_gl *gl, GLenum format, int width, int height,
                        size_t *count);

/* RL_ERR_SYSTEM, with `what` was being done and GL's error, if any call since the last check went wrong. */
int rl_gl_check(struct rl_gl *gl, const char *what, struct rl_error *error);

/* The same, for the frame buffer now bound and what is attached to it. */
int rl_gl_check_framebuffer(struct rl_gl *gl, const char *what, struct rl_error *error);

#endif
