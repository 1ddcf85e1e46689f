/* Environment maps: the polygon lights drawn into the faces of a cube map about an object's centre, the
 * nearest one winning.
 *
 * What is lost: a light's edge is one texel sharp, and the map has one centre for all of the object's surface
 * (so has the paper). Parts of a light nearer to that centre than a millionth of the distance to the farthest
 * light are cut off.
 */
#include <math.h>
#include <stdlib.h>

#include "base/clock.h"
#include "base/hash.h"
#include "gpu/scene.h"
#include "gpu/textures.h"
#include "scene/plan_sizes.h"

static const double NEAR_RATIO = 1e-6;

/* What is drawn into it is never counted on, but a large one takes longer to allocate than to draw: its pages are cleared. */
static int make_cube(GLuint *cube, struct rl_gpu_scene *gs, struct rl_error *error)
{
    struct rl_gpu *gpu = gs->gpu;
    const struct rl_settings *s = &gs->plan->settings;
    const int what[] = {s->env_size, (int)s->env_format};
    uint64_t key = rl_hash_bytes(RL_HASH_START, what, sizeof what);
    *cube = rl_kept_take(&gpu->kept, RL_KEPT_STORAGE, key);
    if (*cube) {
        gs->counters.textures_kept++;
        return RL_OK;
    }
    int status = rl_cube_make(cube, &gpu->gl, s, error);
    if (status == RL_OK)
        return rl_kept_add(&gpu->kept, &gpu->gl, RL_KEPT_STORAGE, key, *cube,
                           rl_plan_size_environment(s).bytes, error);
    gpu->gl.DeleteTextures(1, cube);
    *cube = 0;
    return status;
}

int rl_environments_make(struct rl_gpu_scene *gs, struct rl_error *error)
{
    struct rl_gl *gl = &gs->gpu->gl;
    int size = gs->plan->settings.env_size;
    gs->environment_unit = rl_texel_unit(gs->plan->settings.env_format, gs->plan->radiance_scale);
    if (gs->plan->n_environments == 0)
        return RL_OK;
    for (size_t i = 0; i < gs->plan->n_environments; i++) {
        int status = make_cube(&gs->environment[i], gs, error);
        if (status != RL_OK)
            return status;
        gs->counters.textures++;
    }
    gl->GenFramebuffers(1, &gs->environment_framebuffer);
    rl_gl_renderbuffer(&gs->environment_depth, gl, GL_DEPTH_COMPONENT32F, size, size,
                       &gs->counters.renderbuffers);
    return rl_gl_check(gl, "the environment maps' depth buffer", error);
}

void rl_environments_free(struct rl_gpu_scene *gs)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    for (size_t i = 0; gs->environment && i < gs->plan->n_environments; i++)
        rl_kept_release(&gs->gpu->kept, gl, RL_KEPT_STORAGE, gs->environment[i]);
    gl->DeleteFramebuffers(1, &gs->environment_framebuffer);
    gl->DeleteRenderbuffers(1, &gs->environment_depth);
    free(gs->environment);
}

static int bind_face(struct rl_gpu_scene *gs, size_t environment, int face, struct rl_error *error)
{
    struct rl_gl *gl = &gs->gpu->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, gs->environment_framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                             GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face, gs->environment[environment], 0);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, gs->environment_depth);
    return rl_gl_check_framebuffer(gl, "the environment map", error);
}

/* Columns of the matrix whose rows are a face's s, t and outward directions: OpenGL 4.5, table 8.19. */
static const float faces[6][9] = {
    {0, 0, 1, 0, -1, 0, -1, 0, 0}, /* +x: s = -z, t = -y */
    {0, 0, -1, 0, -1, 0, 1, 0, 0}, /* -x: s = +z, t = -y */
    {1, 0, 0, 0, 0, 1, 0, 1, 0},   /* +y: s = +x, t = +z */
    {1, 0, 0, 0, 0, -1, 0, -1, 0}, /* -y: s = +x, t = -z */
    {1, 0, 0, 0, -1, 0, 0, 0, 1},  /* +z: s = +x, t = -y */
    {-1, 0, 0, 0, -1, 0, 0, 0, -1} /* -z: s = -x, t = -y */
};

static double farthest_vertex(const struct rl_scene *scene, rl_vec3 centre)
{
    double farthest = 0.0;
    for (size_t i = 0; i < scene->n_lights; i++)
        for (size_t j = 0; j < scene->light[i].n_polygons; j++)
            for (int k = 0; k < scene->light[i].polygon[j].n; k++)
                farthest = fmax(farthest, v3_length(v3_sub(scene->light[i].polygon[j].vertex[k], centre)));
    return farthest;
}

static int draw_environment(struct rl_gpu_scene *gs, size_t environment, rl_vec3 centre,
                            struct rl_error *error)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    const struct rl_gpu_program *p = &gs->program[gs->plan->environment_program];
    gl->UseProgram(p->id);
    gl->Uniform3f(p->centre, (float)centre.x, (float)centre.y, (float)centre.z);
    gl->Uniform1f(p->near_plane, (float)(NEAR_RATIO * farthest_vertex(gs->scene, centre)));
    gl->BindVertexArray(gs->lights.vertex_array);
    for (int face = 0; face < 6; face++) {
        int status = bind_face(gs, environment, face, error);
        if (status != RL_OK)
            return status;
        gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl->UniformMatrix3fv(p->face, 1, GL_FALSE, faces[face]);
        gl->DrawArrays(GL_TRIANGLES, 0, gs->lights.n_vertices);
        gs->counters.draws++;
        gs->counters.triangles += (size_t)gs->lights.n_vertices / 3;
    }
    return RL_OK;
}

static int draw_environments(struct rl_gpu_scene *gs, struct rl_error *error)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    int size = gs->plan->settings.env_size;
    gl->Viewport(0, 0, size, size);
    gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl->Disable(GL_BLEND);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_STENCIL_TEST);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthMask(GL_TRUE);
    gl->DepthFunc(GL_GREATER);
    gl->ClearDepth(0.0);
    int status = RL_OK;
    size_t drawn = 0;
    for (size_t i = 0; i < gs->scene->n_objects && status == RL_OK; i++)
        if (gs->plan->environment[i] ==
            (int)drawn) /* others are those of an object before, at the same centre */
            status = draw_environment(gs, drawn++, gs->scene->object[i].centre, error);
    gl->ClearDepth(1.0);
    gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    return status;
}

int rl_gpu_scene_environment(struct rl_gpu_scene *gs, double *seconds, struct rl_error *error)
{
    double start = rl_clock_seconds();
    *seconds = 0.0;
    int status = rl_lights_fill(gs, error);
    if (status == RL_OK && gs->plan->n_environments > 0)
        status = draw_environments(gs, error);
    gs->gpu->gl.Finish();
    *seconds = rl_clock_seconds() - start;
    return status == RL_OK ? rl_gl_check(&gs->gpu->gl, "the environment pass", error) : status;
}

int rl_gpu_scene_read_environment(struct rl_gpu_scene *gs, size_t object, struct rl_image *image,
                                  struct rl_error *error)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    if (object >= gs->scene->n_objects || gs->plan->environment[object] < 0)
        return rl_fail(error, RL_ERR_INPUT, "object %zu has no environment map", object);
    int size = gs->plan->settings.env_size;
    int status = rl_image_allocate(image, 6 * size, size, 3, error);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->PixelStorei(GL_PACK_ROW_LENGTH, 6 * size);
    for (int face = 0; face < 6 && status == RL_OK; face++) {
        status = bind_face(gs, (size_t)gs->plan->environment[object], face, error);
        if (status == RL_OK)
            gl->ReadPixels(0, 0, size, size, GL_RGB, GL_FLOAT, rl_image_pixel(image, face * size, 0));
    }
    gl->PixelStorei(GL_PACK_ROW_LENGTH, 0);
    if (status == RL_OK)
        status = rl_gl_check(&gs->gpu->gl, "reading the environment map", error);
    if (status != RL_OK) {
        rl_image_clear(image);
        return status;
    }
    for (size_t i = 0; i < (size_t)size * (size_t)size * 18; i++)
        image->data[i] *= gs->environment_unit;
    return RL_OK;
}
