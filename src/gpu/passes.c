/* One frame: the surface pass, then, where the plan has them, the sphere and highlight passes. */
#include <stdbool.h>

#include "base/clock.h"
#include "gpu/scene.h"

static void set_params(const struct rl_gl *gl, GLint location, int n, const float params[][4])
{
    if (location >= 0 && n > 0)
        gl->Uniform4fv(location, n, params[0]);
}

static void set_material(const struct rl_gpu_scene *gs, const struct rl_gpu_program *p,
                         const struct rl_plan_material *m)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    const struct rl_gpu_material *values = &gs->material[m - gs->plan->material];
    gl->Uniform3f(p->specular, values->specular[0], values->specular[1], values->specular[2]);
    gl->Uniform1f(p->sphere_scale, (float)(1.0 + m->margin));
    for (size_t i = 0; i < m->n_effects; i++)
        set_params(gl, p->effect_params[rl_effect_row(m->effect[i])], m->effect[i]->n_params,
                   values->effect_params[i]);
    if (m->method)
        set_params(gl, p->method_params, m->method->n_params, values->method_params);
    if (m->pattern >= 0)
        gl->BindBufferBase(GL_UNIFORM_BUFFER, RL_BLOCK_PATTERN, gs->pattern[m->pattern]);
    if (m->normal_map >= 0) {
        gl->ActiveTexture(GL_TEXTURE0 + RL_UNIT_NORMAL_MAP);
        gl->BindTexture(GL_TEXTURE_2D, gs->normal_map[m->normal_map]);
    }
}

void rl_frame_set_camera(const struct rl_gpu_scene *gs, const struct rl_gpu_program *p)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    const struct rl_camera *camera = &gs->scene->camera;
    double matrix[16];
    float single[16];
    rl_camera_matrix(camera, gs->width, gs->height, gs->plan->settings.reversed_depth, matrix);
    for (int i = 0; i < 16; i++)
        single[i] = (float)matrix[i];
    gl->UniformMatrix4fv(p->clip_from_world, 1, GL_FALSE, single);
    gl->Uniform3f(p->eye, (float)camera->position.x, (float)camera->position.y, (float)camera->position.z);
}

void rl_frame_draw_mesh(struct rl_gpu_scene *gs, const struct rl_gpu_object *object)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    gl->BindVertexArray(object->vertex_array);
    gl->DrawElements(GL_TRIANGLES, object->n_indices, GL_UNSIGNED_INT, NULL);
    gs->counters.draws++;
    gs->counters.triangles += (size_t)object->n_indices / 3;
    gs->counters.triangles_culled += gs->plan->settings.culling ? object->n_back_faces : 0;
}

static void draw_object(struct rl_gpu_scene *gs, const struct rl_gpu_object *object, int program)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    const struct rl_gpu_program *p = &gs->program[program];
    gl->UseProgram(p->id);
    rl_frame_set_camera(gs, p);
    set_material(gs, p, object->material);
    float seen_from[4] = {0.0f};
    if (object->environment) {
        const rl_vec3 centre = gs->scene->object[object - gs->object].centre;
        seen_from[0] = (float)centre.x;
        seen_from[1] = (float)centre.y;
        seen_from[2] = (float)centre.z;
        seen_from[3] = 1.0f;
        gl->ActiveTexture(GL_TEXTURE0 + RL_UNIT_ENVIRONMENT);
        gl->BindTexture(GL_TEXTURE_CUBE_MAP, object->environment);
        gl->Uniform1f(p->environment_unit, gs->environment_unit);
    }
    gl->Uniform4fv(p->seen_from, 1, seen_from);
    rl_frame_draw_mesh(gs, object);
}

/* Other scenes on the context, and environment maps, may have another range of depth. */
static void set_depth(const struct rl_gpu_scene *gs)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    bool reversed = gs->plan->settings.reversed_depth;
    gl->ClipControl(GL_LOWER_LEFT, reversed ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    gl->ClearDepth(reversed ? 0.0 : 1.0);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthMask(GL_TRUE);
    gl->DepthFunc(reversed ? GL_GREATER : GL_LESS);
}

void rl_frame_begin(const struct rl_gpu_scene *gs)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, gs->framebuffer);
    gl->Viewport(0, 0, gs->width, gs->height);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    set_depth(gs);
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
              (gs->plan->stencil ? (GLbitfield)GL_STENCIL_BUFFER_BIT : 0));
    if (gs->plan->settings.culling)
        gl->Enable(GL_CULL_FACE);
    else
        gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    gl->Disable(GL_STENCIL_TEST);
}

static void surface_pass(struct rl_gpu_scene *gs)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    rl_lights_bind(gs);
    for (size_t i = 0; i < gs->scene->n_objects; i++)
        if (gs->plan->object[i].drawn)
            draw_object(gs, &gs->object[i], gs->object[i].material->surface_program);
    /* What follows draws again what is visible and nothing else. */
    gl->DepthFunc(GL_EQUAL);
    gl->DepthMask(GL_FALSE);
}

/* Whether the object's highlight has a pass of its own in which it is drawn. */
static bool has_highlight(const struct rl_gpu_scene *gs, size_t object)
{
    const struct rl_plan_object *o = &gs->plan->object[object];
    return o->drawn && o->highlit && gs->object[object].material->highlight_program >= 0;
}

static void sphere_pass(struct rl_gpu_scene *gs)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl->Enable(GL_STENCIL_TEST);
    gl->StencilFunc(GL_ALWAYS, 1, 0xff);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (size_t i = 0; i < gs->scene->n_objects; i++)
        if (has_highlight(gs, i) && gs->object[i].material->sphere_program >= 0)
            draw_object(gs, &gs->object[i], gs->object[i].material->sphere_program);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/* The stencil buffer lets a pixel through once: of surfaces at one depth (a triangle that a mesh has twice)
 * the first one, which is also the one that the surface pass has shown. */
static void highlight_pass(struct rl_gpu_scene *gs)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    gl->Enable(GL_STENCIL_TEST);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    for (size_t i = 0; i < gs->scene->n_objects; i++) {
        const struct rl_plan_material *m = gs->object[i].material;
        if (!has_highlight(gs, i))
            continue;
        gl->StencilFunc(GL_EQUAL, m->sphere_program >= 0 ? 1 : 0, 0xff);
        draw_object(gs, &gs->object[i], m->highlight_program);
    }
}

int rl_gpu_scene_warm_up(struct rl_gpu_scene *gs, struct rl_error *error)
{
    const struct rl_gl *gl = &gs->gpu->gl;
    const struct rl_gpu_counters before = gs->counters;
    double seconds;
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(0, 0, 1, 1);
    int status = rl_gpu_scene_frame(gs, &seconds, error);
    gl->Disable(GL_SCISSOR_TEST);
    gs->counters = before;
    return status;
}

int rl_gpu_scene_frame(struct rl_gpu_scene *gs, double *seconds, struct rl_error *error)
{
    bool spheres = false;
    for (size_t i = 0; i < gs->scene->n_objects; i++)
        spheres = spheres || (has_highlight(gs, i) && gs->object[i].material->sphere_program >= 0);
    double start = rl_clock_seconds();
    rl_frame_begin(gs);
    surface_pass(gs);
    if (spheres)
        sphere_pass(gs);
    if (gs->plan->stencil)
        highlight_pass(gs);
    gs->gpu->gl.Finish();
    *seconds = rl_clock_seconds() - start;
    return rl_gl_check(&gs->gpu->gl, "drawing a frame", error);
}
