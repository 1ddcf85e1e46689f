/* Occluders of a scene (see occluders.h). */
#include "reference/occluders.h"

#include <math.h>
#include <stdlib.h>

#include "reference/silhouette.h"

/* Where a triangle passes through the plane of a light, near that light: before the plane it hides, behind it does not. */
struct passage {
    rl_vec3 a, b;
};

struct occluder {
    struct rl_mesh_edges edges;
    size_t n_passages, capacity;
    struct passage *passage;
};

struct rl_occluders {
    const struct rl_scene *scene;
    const struct rl_shadow_rays *rays;
    struct occluder *object;
    size_t most_edges, most_triangles; /* of any object */
};

static rl_vec3 position(const struct rl_mesh *mesh, uint32_t i)
{
    return v3(mesh->position[i][0], mesh->position[i][1], mesh->position[i][2]);
}

static int add_passage(struct occluder *o, rl_vec3 a, rl_vec3 b, struct rl_error *error)
{
    if (o->n_passages == o->capacity) {
        size_t capacity = o->capacity > 0 ? 2 * o->capacity : 16;
        struct passage *more = realloc(o->passage, capacity * sizeof *more);
        if (!more)
            return rl_fail_memory(error, "the shadows");
        o->passage = more;
        o->capacity = capacity;
    }
    o->passage[o->n_passages++] = (struct passage){a, b};
    return RL_OK;
}

/* A triangle against the plane of a light's polygon. */
static int pass_through(struct occluder *o, const rl_vec3 corner[3], const struct rl_polygon *polygon,
                        const struct rl_light *light, struct rl_error *error)
{
    double height[3];
    rl_vec3 end[2], middle = v3(0.0, 0.0, 0.0);
    int n = 0;
    for (int i = 0; i < 3; i++) {
        height[i] = v3_dot(polygon->normal, v3_sub(corner[i], polygon->vertex[0]));
        middle = v3_madd(middle, 1.0 / 3.0, corner[i]);
    }
    for (int i = 0; i < 3 && n < 2; i++) {
        int j = (i + 1) % 3;
        if ((height[i] > 0.0) != (height[j] > 0.0))
            end[n++] = v3_madd(corner[i], height[i] / (height[i] - height[j]), v3_sub(corner[j], corner[i]));
    }
    double reach = light->radius;
    for (int i = 0; i < 3; i++)
        reach = fmax(reach, light->radius + v3_length(v3_sub(corner[i], middle)));
    if (n < 2 || v3_length(v3_sub(middle, light->centre)) > reach)
        return RL_OK;
    return add_passage(o, end[0], end[1], error);
}

static int find_passages(struct occluder *o, const struct rl_object *object, const struct rl_light *light,
                         struct rl_error *error)
{
    const struct rl_mesh *mesh = &object->mesh;
    if (v3_length(v3_sub(object->centre, light->centre)) > object->radius + light->radius)
        return RL_OK;
    int status = RL_OK;
    for (size_t i = 0; i < mesh->n_triangles; i++) {
        rl_vec3 corner[3];
        for (int j = 0; j < 3; j++)
            corner[j] = position(mesh, mesh->triangle[i][j]);
        for (size_t j = 0; j < light->n_polygons && status == RL_OK; j++)
            status = pass_through(o, corner, &light->polygon[j], light, error);
    }
    return status;
}

int rl_occluders_make(struct rl_occluders **out, const struct rl_scene *scene,
                      const struct rl_shadow_rays *rays, struct rl_error *error)
{
    struct rl_occluders *o = calloc(1, sizeof *o);
    *out = NULL;
    if (o)
        o->object = calloc(scene->n_objects + 1, sizeof *o->object);
    if (!o || !o->object) {
        free(o);
        return rl_fail_memory(error, "the shadows");
    }
    o->scene = scene;
    o->rays = rays;
    int status = RL_OK;
    for (size_t i = 0; i < scene->n_objects && status == RL_OK; i++) {
        const struct rl_object *object = &scene->object[i];
        status = rl_mesh_edges_make(&o->object[i].edges, &object->mesh, error);
        for (size_t j = 0; j < scene->n_lights && status == RL_OK; j++)
            status = find_passages(&o->object[i], object, &scene->light[j], error);
        if (o->object[i].edges.n_edges > o->most_edges)
            o->most_edges = o->object[i].edges.n_edges;
        if (object->mesh.n_triangles > o->most_triangles)
            o->most_triangles = object->mesh.n_triangles;
    }
    if (status != RL_OK)
        rl_occluders_free(o);
    else
        *out = o;
    return status;
}

void rl_occluders_free(struct rl_occluders *o)
{
    if (!o)
        return;
    for (size_t i = 0; i < o->scene->n_objects; i++) {
        rl_mesh_edges_clear(&o->object[i].edges);
        free(o->object[i].passage);
    }
    free(o->object);
    free(o);
}

/* A cone of directions from P that holds a sphere; whole: P lies inside. */
struct cone {
    rl_vec3 axis;
    double sin, cos, distance, radius;
    bool whole;
};

static struct cone cone_about(rl_vec3 from_p, double radius)
{
    double distance = v3_length(from_p);
    /* A little wider than it is, for rounding. */
    double sine = distance > 0.0 ? 1.0001 * radius / distance + 1e-9 : 1.0;
    struct cone c = {v3_normalize(from_p), sine, 0.0, distance, radius, !(sine < 1.0)};
    c.cos = c.whole ? 0.0 : sqrt(1.0 - sine * sine);
    return c;
}

/* Whether the two have a direction in common: the angle between the axes is at most the sum of their half angles. */
static bool cones_meet(const struct cone *a, const struct cone *b)
{
    return a->whole || b->whole || v3_dot(a->axis, b->axis) >= a->cos * b->cos - a->sin * b->sin;
}

/* Whether something in cone c, a sphere, may come between P and one of the lights. */
static bool may_hide(const struct rl_occluders_view *view, const struct cone *c)
{
    const struct rl_scene *scene = view->occluders->scene;
    for (size_t i = 0; i < scene->n_lights; i++) {
        const struct rl_light *light = &scene->light[i];
        if (view->light != RL_OCCLUDERS_LIGHTS && view->light != i)
            continue;
        struct cone l = cone_about(v3_sub(light->centre, view->P), light->radius);
        if (c->distance - c->radius <= l.distance + l.radius && cones_meet(c, &l))
            return true;
    }
    return false;
}

/* An edge from a to b, if it may matter. The angle of doubt: of rays and edges in double precision, some units in the last place of
 * the coordinates over the distance. */
static bool add_edge(struct rl_occluders_view *view, rl_vec3 a, rl_vec3 b)
{
    const double unit = 0x1p-50;
    rl_vec3 from = v3_sub(a, view->P), to = v3_sub(b, view->P);
    rl_vec3 middle = v3_scale(0.5, v3_add(from, to));
    double half = 0.5 * v3_length(v3_sub(to, from));
    struct cone c = cone_about(middle, half);
    if (!may_hide(view, &c))
        return true;
    /* The nearest that the edge comes to P. */
    double s =
        half > 0.0 ? fmax(-1.0, fmin(1.0, -v3_dot(middle, v3_sub(to, from)) / (2.0 * half * half))) : 0.0;
    double distance = v3_length(v3_madd(middle, 0.5 * s, v3_sub(to, from)));
    double size = fmax(v3_length(view->P), fmax(v3_length(a), v3_length(b)));
    return rl_occlusion_add(&view->occlusion, from, to, unit * (1.0 + size / fmax(1e-300, distance)));
}

static bool see_object(struct rl_occluders_view *view, const struct occluder *o)
{
    const struct rl_mesh *mesh = o->edges.mesh;
    size_t n = rl_mesh_silhouette(view->found, view->facing, &o->edges, view->P);
    bool room = true;
    for (size_t i = 0; i < n && room; i++) {
        const struct rl_mesh_edge *edge = &o->edges.edge[view->found[i]];
        room = add_edge(view, position(mesh, edge->a), position(mesh, edge->b));
    }
    for (size_t i = 0; i < o->n_passages && room; i++)
        room = add_edge(view, o->passage[i].a, o->passage[i].b);
    return room;
}

static bool hidden(void *user, rl_vec3 L, double distance)
{
    const struct rl_occluders_view *view = user;
    return rl_shadow_rays_hidden(view->occluders->rays, view->own, view->P, L, distance);
}

static bool begin(struct rl_occluders_view *view, const struct rl_occluders *occluders,
                  const struct rl_surface *surface, size_t own)
{
    if (!view->found)
        view->found = malloc((occluders->most_edges + 1) * sizeof *view->found);
    if (!view->facing)
        view->facing = malloc(occluders->most_triangles + 1);
    view->occluders = occluders;
    view->P = surface->P;
    view->own = own;
    view->occlusion.ray = hidden;
    view->occlusion.user = view;
    return view->found && view->facing && rl_occlusion_begin(&view->occlusion, surface);
}

static enum rl_occluders_seen see(struct rl_occluders_view *view, const struct rl_occluders *occluders,
                                  const struct rl_surface *surface, size_t own, bool attenuation,
                                  size_t light)
{
    const struct rl_scene *scene = occluders->scene;
    bool some = false;
    view->light = light;
    view->P = surface->P;
    view->occluders = occluders;
    for (size_t i = 0; i < scene->n_objects; i++) {
        const struct rl_object *object = &scene->object[i];
        rl_vec3 centre = v3_sub(object->centre, surface->P);
        struct cone c = cone_about(centre, object->radius);
        bool below = attenuation && v3_dot(centre, surface->N) < -1.0001 * object->radius;
        if (i == own || below || !may_hide(view, &c))
            continue;
        if ((!some && !begin(view, occluders, surface, own)) || !see_object(view, &occluders->object[i]))
            return RL_OCCLUDERS_NO_MEMORY;
        some = true;
    }
    return some ? RL_OCCLUDERS_SOME : RL_OCCLUDERS_NONE;
}

enum rl_occluders_seen rl_occluders_see(struct rl_occluders_view *view, const struct rl_occluders *occluders,
                                        const struct rl_surface *surface, size_t own, bool attenuation)
{
    return see(view, occluders, surface, own, attenuation, RL_OCCLUDERS_LIGHTS);
}

enum rl_occluders_seen rl_occluders_see_light(struct rl_occluders_view *view,
                                              const struct rl_occluders *occluders,
                                              const struct rl_surface *surface, size_t own, size_t light)
{
    return see(view, occluders, surface, own, true, light);
}

void rl_occluders_view_clear(struct rl_occluders_view *view)
{
    rl_occlusion_clear(&view->occlusion);
    free(view->found);
    free(view->facing);
    *view = (struct rl_occluders_view){0};
}
