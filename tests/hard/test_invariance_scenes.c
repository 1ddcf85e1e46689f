/* What must not change a picture of the CPU renderer: the unit of length (no bit), the direction of the axes and the order of the lights (rounding
 * only). Over scenes that come with the program, which have every effect, meshes, all kinds of lights and shadows. */
#include "gpu/against_cpu.h"

#include <float.h>

#include "base/paths.h"

static const char *const scenes[] = {"three-lights", "lamps",  "window",      "metals",      "glass",
                                     "fur",          "facets", "ball-shadow", "teapot-star", "office"};
static const char *const methods[] = {"plain", "exhaustive", "reference"};

#define LENGTH(a) (sizeof(a) / sizeof(a)[0])

static void load(struct rl_scene *scene, const char *name, const char *method)
{
    struct rl_error error;
    char relative[64], path[4096];
    snprintf(relative, sizeof relative, "studies/scenes/%s.yaml", name);
    check_ok(rl_path_data(path, sizeof path, relative, &error), &error);
    check_ok(rl_scene_load(scene, path, &error), &error);
    scene->settings.width = 24;
    scene->settings.height = 18;
    scene->settings.env_size = 16;
    scene->settings.tolerance = 1e-5;
    scene->settings.shadows = scene->settings.shadows && strcmp(method, "reference") == 0;
    for (size_t i = 0; i < scene->n_materials; i++)
        if (scene->material[i].method)
            scene->material[i].method = method;
}

/* Every point of the scene through `move`, lengths times `unit`, directions through `turn`. */
typedef rl_vec3 map(rl_vec3 a, double unit);

static rl_vec3 stretch(rl_vec3 a, double unit)
{
    return v3_scale(unit, a);
}

/* x, y and z in turn: a third of a full turn about (1, 1, 1), without rounding. */
static rl_vec3 turn(rl_vec3 a, double unit)
{
    return v3_scale(unit, v3(a.z, a.x, a.y));
}

static void move_float(float a[3], map *f, double unit)
{
    rl_vec3 b = f(v3((double)a[0], (double)a[1], (double)a[2]), unit);
    a[0] = (float)b.x;
    a[1] = (float)b.y;
    a[2] = (float)b.z;
}

static void move_light(struct rl_light *light, map *f, double unit)
{
    for (size_t i = 0; i < light->n_polygons; i++) {
        struct rl_polygon *polygon = &light->polygon[i];
        for (int k = 0; k < polygon->n; k++)
            polygon->vertex[k] = f(polygon->vertex[k], unit);
        polygon->normal = f(polygon->normal, 1.0);
        polygon->area *= unit * unit;
    }
    light->centroid = f(light->centroid, unit);
    light->centre = f(light->centre, unit);
    light->normal = f(light->normal, 1.0);
    light->radius *= unit;
    light->area *= unit * unit;
}

static void move_scene(struct rl_scene *scene, map *f, double unit)
{
    struct rl_camera *c = &scene->camera;
    c->position = f(c->position, unit);
    c->right = f(c->right, 1.0);
    c->up = f(c->up, 1.0);
    c->forward = f(c->forward, 1.0);
    c->near_plane *= unit;
    c->far_plane *= unit;
    for (size_t i = 0; i < scene->n_objects; i++) {
        struct rl_object *o = &scene->object[i];
        for (size_t v = 0; v < o->mesh.n_vertices; v++) {
            move_float(o->mesh.position[v], f, unit);
            move_float(o->mesh.normal[v], f, 1.0);
        }
        o->centre = f(o->centre, unit);
        o->radius *= unit;
    }
    for (size_t i = 0; i < scene->n_lights; i++)
        move_light(&scene->light[i], f, unit);
    for (size_t i = 0; i < scene->n_sources; i++) {
        struct rl_source *s = &scene->source[i];
        s->at = f(s->at, s->parallel ? 1.0 : unit);
        for (int k = 0; k < 3 && !s->parallel; k++)
            s->strength[k] *= unit * unit;
    }
}

static void reverse_lights(struct rl_scene *scene)
{
    for (size_t i = 0, j = scene->n_lights; i + 1 < j; i++) {
        struct rl_light swap = scene->light[i];
        scene->light[i] = scene->light[--j];
        scene->light[j] = swap;
    }
    for (size_t i = 0, j = scene->n_sources; i + 1 < j; i++) {
        struct rl_source swap = scene->source[i];
        scene->source[i] = scene->source[--j];
        scene->source[j] = swap;
    }
}

struct difference {
    size_t pixels, outlines; /* that differ; and in what they show, or whether anything */
    double worst;            /* of the others, in parts of 1 + their value */
};

static struct difference compare(const struct rl_image *a, const struct rl_image *b)
{
    struct difference d = {0, 0, 0.0};
    for (size_t i = 0; i < (size_t)a->width * (size_t)a->height; i++) {
        const float *p = a->data + 4 * i, *q = b->data + 4 * i;
        double off = 0.0;
        bool same = true;
        for (int c = 0; c < 4; c++) {
            assert_true(isfinite(p[c]) && isfinite(q[c]));
            same = same && p[c] == q[c];
            off = fmax(off, fabs((double)p[c] - (double)q[c]) / (1.0 + fabs((double)p[c])));
        }
        d.pixels += !same;
        /* Half of a value comes from another surface, not from rounding. */
        bool outline = p[3] != q[3] || off > 0.01;
        d.outlines += outline;
        d.worst = outline ? d.worst : fmax(d.worst, off);
    }
    return d;
}

/* The picture of the scene as it is. */
static void draw(struct rl_image *image, const char *name, const char *method)
{
    struct rl_scene scene;
    load(&scene, name, method);
    render_cpu(image, &scene);
    rl_scene_clear(&scene);
}

static struct difference moved(const struct rl_image *here, const char *name, const char *method, map *f,
                               double unit, bool reversed)
{
    struct rl_scene other;
    struct rl_image there;
    load(&other, name, method);
    move_scene(&other, f, unit);
    if (reversed)
        reverse_lights(&other);
    render_cpu(&there, &other);
    struct difference d = compare(here, &there);
    rl_image_clear(&there);
    rl_scene_clear(&other);
    return d;
}

static void check_unit(const struct rl_image *here, const char *name, const char *method)
{
    static const int power[] = {-17, 11};
    for (size_t p = 0; p < LENGTH(power); p++) {
        struct difference d = moved(here, name, method, stretch, ldexp(1.0, power[p]), false);
        if (d.pixels > 0)
            fail_msg("%s, %s, lengths times 2^%d: %zu pixels differ, %zu of them in what they show; %.2g",
                     name, method, power[p], d.pixels, d.outlines, d.worst);
    }
}

/* Exhaustive's cube map has faces, and a turn by thirds takes them onto each other. In double precision rounding is far below 1e-9; where a
 * single-precision picture rounds the other way it is a unit of that. */
static void check_turn(const struct rl_image *here, const char *name, const char *method)
{
    struct difference d = moved(here, name, method, turn, 1.0, false);
    print_message("%-12s %-10s turned: %zu pixels of other bits, %zu at outlines, farthest %.2g\n", name,
                  method, d.pixels, d.outlines, d.worst);
    assert_true(d.worst <= 4.0 * FLT_EPSILON);
    assert_in_range(d.outlines, 0, 2);
}

static void check_order(const struct rl_image *here, const char *name, const char *method)
{
    struct difference d = moved(here, name, method, stretch, 1.0, true);
    if (d.pixels > 0)
        print_message("%-12s %-10s lights in another order: %zu pixels of other bits, farthest %.2g\n", name,
                      method, d.pixels, d.worst);
    assert_true(d.worst <= 4.0 * FLT_EPSILON);
    assert_int_equal(d.outlines, 0);
}

static void test_pictures(void **state)
{
    (void)state;
    for (size_t i = 0; i < LENGTH(scenes); i++)
        for (size_t m = 0; m < LENGTH(methods); m++) {
            struct rl_image here;
            draw(&here, scenes[i], methods[m]);
            check_unit(&here, scenes[i], methods[m]);
            check_turn(&here, scenes[i], methods[m]);
            check_order(&here, scenes[i], methods[m]);
            rl_image_clear(&here);
        }
}

/* A test that cannot fail is none: something absolute is seen, and so is a light that was left behind. */
static void test_faults_are_seen(void **state)
{
    (void)state;
    struct rl_scene other;
    struct rl_image here, there;
    draw(&here, "window", "reference");
    load(&other, "window", "reference");
    move_scene(&other, stretch, 0.5);
    other.camera.position.x += 1e-5;
    render_cpu(&there, &other);
    assert_true(compare(&here, &there).pixels > 0);
    rl_image_clear(&there);
    other.camera.position.x -= 1e-5;
    other.light[0].polygon[0].vertex[0].y += 1e-3;
    render_cpu(&there, &other);
    assert_true(compare(&here, &there).pixels > 0);
    rl_image_clear(&there);
    rl_image_clear(&here);
    rl_scene_clear(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures),
        cmocka_unit_test(test_faults_are_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
