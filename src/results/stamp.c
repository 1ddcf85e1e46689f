/* Provenance attributes (see stamp.h). */
#include "results/stamp.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/hash.h"
#include "base/machine.h"
#include "base/version.h"

struct stamp {
    struct rl_image *image;
    struct rl_error *error;
    int status; /* the first failure; later calls do nothing */
};

static void text(struct stamp *stamp, const char *name, const char *value)
{
    char full[64];
    snprintf(full, sizeof full, "roughlight:%s", name);
    if (stamp->status == RL_OK)
        stamp->status = rl_image_set_string(stamp->image, full, value, stamp->error);
}

static void number(struct stamp *stamp, const char *name, double value)
{
    char full[64];
    snprintf(full, sizeof full, "roughlight:%s", name);
    if (stamp->status == RL_OK)
        stamp->status = rl_image_set_number(stamp->image, full, value, stamp->error);
}

/* "glaze: random 4, R_r 30; ground: none, R_r 10, gouraud" */
static void materials(struct stamp *stamp, const struct rl_scene *scene, const struct rl_plan *plan)
{
    char line[1024] = "";
    size_t used = 0;
    for (size_t i = 0; i < plan->n_materials && used < sizeof line; i++) {
        const struct rl_plan_material *m = &plan->material[i];
        used += (size_t)snprintf(line + used, sizeof line - used, "%s%s: %s", i ? "; " : "",
                                 scene->material[m->material].name, m->method ? m->method->name : "none");
        if (used < sizeof line && m->method && m->method->sampled)
            used += (size_t)snprintf(line + used, sizeof line - used, " %d", m->samples);
        if (used < sizeof line)
            used += (size_t)snprintf(line + used, sizeof line - used, ", R_r %.17g", m->rr);
        if (used < sizeof line && m->interpolation != RL_INTERPOLATION_PHONG)
            used += (size_t)snprintf(line + used, sizeof line - used, ", %s",
                                     rl_interpolation_name(m->interpolation));
    }
    text(stamp, "materials", line);
}

static void parameters(struct stamp *stamp, const struct rl_settings *s)
{
    char name[32];
    rl_normal_bits_name(name, s->normal_bits);
    text(stamp, "normal_bits", name);
    number(stamp, "normal_size", s->normal_size);
    number(stamp, "env_size", s->env_size);
    text(stamp, "env_format", rl_texel_format_name(s->env_format));
    rl_margin_name(name, s);
    if (s->margin_kind == RL_MARGIN_VALUE)
        number(stamp, "margin", s->margin);
    else
        text(stamp, "margin", name);
    text(stamp, "attenuation", s->attenuation ? "on" : "off");
    text(stamp, "frame", rl_frame_name(s->frame));
    text(stamp, "light_from", s->light_from == RL_LIGHT_FROM_OBJECT ? "object" : "point");
    text(stamp, "shadows", s->shadows ? "on" : "off");
    text(stamp, "culling", s->culling ? "on" : "off");
    number(stamp, "depth_bits", s->depth_bits);
    text(stamp, "reversed_depth", s->reversed_depth ? "on" : "off");
    number(stamp, "tolerance", s->tolerance);
    snprintf(name, sizeof name, "%llu", (unsigned long long)s->seed);
    text(stamp, "seed", name); /* as text: a number would lose digits above 2^53 */
}

int rl_stamp_image(struct rl_image *image, const struct rl_scene *scene, const struct rl_plan *plan,
                   const char *renderer, int threads, double seconds, struct rl_error *error)
{
    struct stamp stamp = {image, error, RL_OK};
    char line[256];
    text(&stamp, "version", rl_version.version);
    snprintf(line, sizeof line, "%s%s", rl_version.commit, rl_version.dirty ? " (modified)" : "");
    text(&stamp, "commit", line);
    text(&stamp, "compiler", rl_version.compiler);
    const char *slash = strrchr(scene->path, '/');
    text(&stamp, "scene",
         slash ? slash + 1 : scene->path); /* without its folder, which says nothing elsewhere */
    rl_hash_text(line, scene->hash);
    text(&stamp, "scene_hash", line);
    materials(&stamp, scene, plan);
    parameters(&stamp, &plan->settings);
    /* By the name that OpenEXR has for the luminance of R = G = B = 1 (its Standard Attributes). */
    if (scene->white > 0.0 && stamp.status == RL_OK)
        stamp.status = rl_image_set_number(image, "whiteLuminance", scene->white, error);
    text(&stamp, "renderer", renderer);
    rl_machine_cpu(line, sizeof line);
    text(&stamp, "cpu", line);
    number(&stamp, "threads", threads);
    number(&stamp, "seconds", seconds);
    time_t now = time(NULL);
    struct tm utc;
    if (gmtime_r(&now, &utc) && strftime(line, sizeof line, "%Y-%m-%dT%H:%M:%SZ", &utc))
        text(&stamp, "date", line);
    return stamp.status;
}

int rl_stamp_accuracy(struct rl_image *image, const struct rl_stamp_accuracy *accuracy,
                      struct rl_error *error)
{
    struct stamp stamp = {image, error, RL_OK};
    number(&stamp, "foreground", (double)accuracy->foreground);
    number(&stamp, "within_tolerance", (double)accuracy->within);
    number(&stamp, "worst_error", accuracy->worst_error);
    number(&stamp, "rms_error", accuracy->rms_error);
    number(&stamp, "mean_error", accuracy->mean_error);
    if (accuracy->max_seconds > 0.0)
        number(&stamp, "max_seconds", accuracy->max_seconds);
    return stamp.status;
}

static const char key_name[] = "roughlight:key";

int rl_stamp_key(struct rl_image *image, const char *key, struct rl_error *error)
{
    return rl_image_set_string(image, key_name, key, error);
}

bool rl_stamp_has_key(const struct rl_image *image, const char *key)
{
    const struct rl_attribute *a = rl_image_attribute(image, key_name);
    return a && a->string && strcmp(a->string, key) == 0;
}
