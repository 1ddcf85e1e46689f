/* See plan_sizes.h. */
#include "scene/plan_sizes.h"

enum { FACES = 6, VECTOR = 3 * sizeof(float), TRIANGLE = 3 * sizeof(uint32_t) };

/* ---- Textures ---- */

static struct rl_plan_size image(const char *format, size_t texel, int width, int height, size_t count)
{
    return (struct rl_plan_size){.format = format,
                                 .width = width,
                                 .height = height,
                                 .count = count,
                                 .bytes = texel * count * (size_t)width * (size_t)height};
}

static size_t texel_bytes(enum rl_texel_format format)
{
    static const size_t bytes[RL_TEXEL_FORMATS] = {
        [RL_TEXEL_RGBA8] = 4,  [RL_TEXEL_RGB10A2] = 4, [RL_TEXEL_R11G11B10F] = 4,
        [RL_TEXEL_RGBA16] = 8, [RL_TEXEL_RGBA16F] = 8, [RL_TEXEL_RGBA32F] = 16,
    };
    return bytes[format];
}

/* Bits that no texel has are kept in 16. */
static enum rl_texel_format normal_format(int bits)
{
    switch (bits) {
    case RL_NORMAL_BITS_HALF:
        return RL_TEXEL_RGBA16F;
    case RL_NORMAL_BITS_FLOAT:
        return RL_TEXEL_RGBA32F;
    case 8:
        return RL_TEXEL_RGBA8;
    case 10:
        return RL_TEXEL_RGB10A2;
    default:
        return RL_TEXEL_RGBA16;
    }
}

struct rl_plan_size rl_plan_size_normal_map(const struct rl_settings *settings)
{
    enum rl_texel_format format = normal_format(settings->normal_bits);
    int size = settings->normal_size;
    struct rl_plan_size map = image(rl_texel_format_name(format), texel_bytes(format), size, size, 1);
    map.uploaded = settings->normal_bits == RL_NORMAL_BITS_HALF ? 2 * map.bytes : map.bytes;
    return map;
}

struct rl_plan_size rl_plan_size_environment(const struct rl_settings *settings)
{
    return image(rl_texel_format_name(settings->env_format), texel_bytes(settings->env_format),
                 settings->env_size, settings->env_size, FACES);
}

/* ---- Render buffers ---- */

struct rl_plan_size rl_plan_size_colour(const struct rl_plan *plan)
{
    return image(rl_texel_format_name(RL_TEXEL_RGBA32F), texel_bytes(RL_TEXEL_RGBA32F), plan->settings.width,
                 plan->settings.height, 1);
}

struct rl_plan_size rl_plan_size_depth(const struct rl_plan *plan)
{
    const struct rl_settings *s = &plan->settings;
    switch (s->depth_bits) {
    case 16:
        return image("depth16", 2, s->width, s->height, 1);
    case 32:
        return plan->stencil ? image("depth32f_stencil8", 8, s->width, s->height, 1)
                             : image("depth32f", 4, s->width, s->height, 1);
    default:
        return image(plan->stencil ? "depth24_stencil8" : "depth24", 4, s->width, s->height, 1);
    }
}

struct rl_plan_size rl_plan_size_environment_depth(const struct rl_plan *plan)
{
    return image("depth32f", 4, plan->settings.env_size, plan->settings.env_size, 1);
}

/* ---- Buffers ---- */

static struct rl_plan_size buffer_of(const char *format, size_t count, size_t bytes)
{
    return (struct rl_plan_size){.format = format, .count = count, .bytes = bytes, .uploaded = bytes};
}

struct rl_plan_size rl_plan_size_pattern(const struct rl_plan_pattern *pattern)
{
    size_t n = (size_t)pattern->samples;
    return buffer_of("float4", n, n * RL_BYTES_MICROFACET);
}

/* Polygons, their corners, and the triangles that they are cut into. */
static void count_polygons(size_t *polygons, size_t *corners, size_t *triangles, const struct rl_plan *plan,
                           const struct rl_scene *scene)
{
    *polygons = rl_plan_polygons(plan, scene);
    *corners = 0;
    for (size_t i = 0; i < plan->n_lights; i++) {
        const struct rl_light *light = &scene->light[plan->light[i]];
        for (size_t j = 0; j < light->n_polygons; j++)
            *corners += (size_t)light->polygon[j].n;
    }
    *triangles = *corners - 2 * *polygons;
}

struct rl_plan_size rl_plan_size_lights(const struct rl_plan *plan, const struct rl_scene *scene,
                                        enum rl_plan_buffer buffer)
{
    size_t polygons, corners, triangles;
    count_polygons(&polygons, &corners, &triangles, plan, scene);
    switch (buffer) {
    case RL_BUFFER_TRIANGLES:
        return buffer_of("float3", 3 * triangles, 3 * triangles * RL_BYTES_LIGHT_VERTEX);
    case RL_BUFFER_POINTS:
        return buffer_of("float4", plan->n_lights, plan->n_lights * RL_BYTES_LIGHT_POINT);
    case RL_BUFFER_SPHERES:
        return buffer_of("float4", plan->n_lights, plan->n_lights * RL_BYTES_LIGHT_SPHERE);
    case RL_BUFFER_SOURCES:
        return buffer_of("float4", plan->n_sources, plan->n_sources * RL_BYTES_LIGHT_SOURCE);
    case RL_BUFFER_POLYGONS:
        return buffer_of("float4", polygons,
                         polygons * RL_BYTES_LIGHT_POLYGON + corners * RL_BYTES_LIGHT_CORNER);
    default:
        return (struct rl_plan_size){0};
    }
}

int rl_plan_size_mesh(struct rl_plan_size size[RL_MESH_PARTS], const struct rl_plan *plan,
                      const struct rl_scene *scene, size_t object, struct rl_error *error)
{
    const struct rl_mesh *mesh = &scene->object[object].mesh;
    const size_t *from = plan->object[object].mesh_from;
    bool facets = rl_plan_facets(plan, scene, object);
    size_t n_twins = 0;
    for (int part = 0; part < RL_MESH_PARTS; part++)
        size[part] = buffer_of(part == RL_MESH_TRIANGLES ? "uint3" : "float3", 0, 0);
    int status = facets ? rl_mesh_own_last(&n_twins, NULL, NULL, mesh, error) : RL_OK;
    if (status != RL_OK)
        return status;
    size_t n = mesh->n_vertices + n_twins;
    /* With a vertex's position stand the centroid and the normal of the triangle that it is the last of. */
    size_t position = facets ? (size_t)3 * VECTOR : VECTOR;
    if (from[RL_MESH_TRIANGLES] == object)
        size[RL_MESH_TRIANGLES] = buffer_of("uint3", mesh->n_triangles, mesh->n_triangles * TRIANGLE);
    if (from[RL_MESH_NORMALS] == object)
        size[RL_MESH_NORMALS] = buffer_of("float3", n, n * VECTOR);
    if (from[RL_MESH_POSITIONS] == object)
        size[RL_MESH_POSITIONS] = buffer_of("float3", n, n * position);
    return RL_OK;
}

/* ---- Draws ---- */

bool rl_plan_runs(const struct rl_plan *plan, const struct rl_scene *scene, size_t program, size_t object)
{
    const struct rl_plan_material *m = rl_plan_of_object(plan, scene, object);
    int index = (int)program;
    if (!plan->object[object].drawn)
        return false;
    if (index == plan->environment_program)
        return plan->environment[object] >= 0;
    return m->surface_program == index ||
           (plan->object[object].highlit && (m->highlight_program == index || m->sphere_program == index));
}

size_t rl_plan_draws(const struct rl_plan *plan, const struct rl_scene *scene, size_t program)
{
    if ((int)program == plan->environment_program)
        return FACES * plan->n_environments;
    size_t n = 0;
    for (size_t i = 0; i < scene->n_objects; i++)
        n += rl_plan_runs(plan, scene, program, i);
    return n;
}
