/* How strong the lights of a scene file are: which quantity says it, in which unit, and what radiance follows (model/photometry.h). And
 * whether a scene is radiometric or photometric. */
#include <stdio.h>
#include <string.h>

#include "model/photometry.h"
#include "scene/scene_build.h"
#include "scene/units.h"

/* Of photometric quantities, in their units: the sun's disc has 1.6e9 cd/m^2. */
#define PHOTOMETRIC_MAX 1e12
#define WHITE_MIN 1e-6
/* On a display as IEC 61966-2-1 (sRGB) has it, whose white is 80 cd/m^2, a picture then shows the luminance that the scene has. */
#define WHITE_DEFAULT 80.0

enum {
    POLYGON = 1 << RL_LIGHT_POLYGON,
    MESH = 1 << RL_LIGHT_MESH,
    POINT = 1 << RL_LIGHT_POINT,
    PARALLEL = 1 << RL_LIGHT_PARALLEL
};

enum { RADIANCE, INTENSITY, IRRADIANCE, LUMINANCE, LUMINOUS_INTENSITY, FLUX, FLUX_PER_SIDE, ILLUMINANCE };

static const struct {
    const char *key;
    unsigned kinds;    /* of lights that it may be given for */
    enum rl_unit unit; /* RL_UNIT_NONE: radiometric, a list of three */
    const char *what, *example;
} quantities[] = {
    [RADIANCE] = {"radiance", POLYGON | MESH, RL_UNIT_NONE, NULL, NULL},
    [INTENSITY] = {"intensity", POINT, RL_UNIT_NONE, NULL, NULL},
    [IRRADIANCE] = {"irradiance", PARALLEL, RL_UNIT_NONE, NULL, NULL},
    [LUMINANCE] = {"luminance", POLYGON | MESH, RL_UNIT_LUMINANCE, "a luminance", "3000 cd/m2"},
    [LUMINOUS_INTENSITY] = {"luminous-intensity", POLYGON | POINT, RL_UNIT_CANDELA, "a luminous intensity",
                            "100 cd"},
    [FLUX] = {"flux", POLYGON | MESH | POINT, RL_UNIT_LUMEN, "a luminous flux", "800 lm"},
    [FLUX_PER_SIDE] = {"flux-per-side", POLYGON, RL_UNIT_LUMEN, "a luminous flux", "800 lm"},
    [ILLUMINANCE] = {"illuminance", PARALLEL, RL_UNIT_LUX, "an illuminance", "500 lx"},
};
enum { N_QUANTITIES = sizeof quantities / sizeof quantities[0], WORDS = 160 };

static bool is_photometric(int quantity)
{
    return quantities[quantity].unit != RL_UNIT_NONE;
}

/* "radiance, luminance or flux": the keys that lights of a kind may have. */
static void list_keys(char words[WORDS], unsigned kind)
{
    size_t used = 0, left = 0;
    for (int q = 0; q < N_QUANTITIES; q++)
        left += (quantities[q].kinds & kind) != 0;
    for (int q = 0; q < N_QUANTITIES && used < WORDS; q++)
        if (quantities[q].kinds & kind) {
            const char *then = left > 2 ? ", " : left == 2 ? " or " : "";
            used += (size_t)snprintf(words + used, WORDS - used, "%s%s", quantities[q].key, then);
            left--;
        }
}

/* ---- One number with its unit ---- */

static int read_measure(const struct rl_scene_builder *b, const char *key, double *value, enum rl_unit unit,
                        double low, const char *what, const char *example)
{
    const struct rl_yaml_node *node = rl_yaml_find(b->tree, key);
    enum rl_unit found = RL_UNIT_NONE;
    if (node && node->kind == RL_YAML_SCALAR && rl_measure_scan(value, &found, node->text) &&
        (found == unit || found == RL_UNIT_NONE) && *value >= low && *value <= PHOTOMETRIC_MAX)
        return RL_OK;
    char hint[96] = "";
    for (int q = 0; q < N_QUANTITIES; q++)
        if (found != unit && quantities[q].unit == found && is_photometric(q) && !hint[0])
            snprintf(hint, sizeof hint, "; %s is the unit of %s", rl_unit_name(found), quantities[q].key);
    return rl_yaml_fail_value(b->tree, b->error, key, "%s from %g to %g in %s, such as %s%s", what, low,
                              PHOTOMETRIC_MAX, rl_unit_name(unit), example, hint);
}

/* ---- Of a light ---- */

/* The one quantity that lights[i] is given by. */
static int find_quantity(const struct rl_scene_builder *b, const char *key, enum rl_light_kind kind,
                         int *quantity)
{
    char path[RL_YAML_KEY_MAX], words[WORDS];
    int found = -1;
    list_keys(words, 1U << kind);
    for (int q = 0; q < N_QUANTITIES; q++) {
        if (!rl_build_has_key(b, key, quantities[q].key))
            continue;
        rl_yaml_key(path, key, quantities[q].key);
        if (!(quantities[q].kinds & 1U << kind))
            return rl_yaml_fail(b->tree, b->error, path, "found it with %s, expected %s",
                                rl_light_kind_key(kind), words);
        if (found >= 0)
            return rl_yaml_fail(b->tree, b->error, path, "found %s and %s, expected one of them",
                                quantities[found].key, quantities[q].key);
        found = q;
    }
    if (found < 0)
        return rl_yaml_fail(b->tree, b->error, key, "found no strength, expected %s", words);
    *quantity = found;
    return RL_OK;
}

/* A number, and a colour that is scaled to the luminance 1. */
static int read_photometric(const struct rl_scene_builder *b, const char *key, int quantity,
                            const double *colour, double rgb[3])
{
    static const double white[3] = {1.0, 1.0, 1.0};
    char path[RL_YAML_KEY_MAX];
    double value = 0.0;
    rl_yaml_key(path, key, quantities[quantity].key);
    int status = read_measure(b, path, &value, quantities[quantity].unit, 0.0, quantities[quantity].what,
                              quantities[quantity].example);
    if (status != RL_OK)
        return status;
    rl_yaml_key(path, key, "colour");
    if (colour)
        status = rl_build_triple(b, path, colour, 0.0, RL_COLOUR_MAX);
    double luminance = rl_luminance(colour ? colour : white);
    if (status == RL_OK && !(luminance > 0.0))
        return rl_yaml_fail(b->tree, b->error, path,
                            "found black, expected a colour with a component above 0");
    for (int c = 0; c < 3; c++)
        rgb[c] = value * ((colour ? colour : white)[c] / luminance);
    return status;
}

static int read_radiometric(const struct rl_scene_builder *b, size_t i, const char *key, int quantity,
                            double rgb[3])
{
    const struct rl_raw_light *raw = &b->raw->lights[i];
    const double *given = quantity == RADIANCE    ? raw->radiance
                          : quantity == INTENSITY ? raw->intensity
                                                  : raw->irradiance;
    char path[RL_YAML_KEY_MAX];
    rl_yaml_key(path, key, "colour");
    if (raw->colour)
        return rl_yaml_fail(b->tree, b->error, path,
                            "found it with %s, which has a colour itself, expected it only with luminance, "
                            "luminous-intensity, flux, flux-per-side or illuminance",
                            quantities[quantity].key);
    memcpy(rgb, given, 3 * sizeof *rgb);
    rl_yaml_key(path, key, quantities[quantity].key);
    return rl_build_triple(b, path, rgb, 0.0, RL_COLOUR_MAX);
}

/* What divides the quantity: radiance follows (of a point intensity, of parallel light irradiance). */
static int divisor(const struct rl_scene_builder *b, const char *key, int quantity, enum rl_light_kind kind,
                   const struct rl_light *light, double *by)
{
    char path[RL_YAML_KEY_MAX];
    *by = 1.0;
    if (quantity == LUMINOUS_INTENSITY && light)
        *by = light->area;
    if (quantity == FLUX_PER_SIDE)
        *by = rl_flux_of_polygon(light->area, 1);
    if (quantity != FLUX)
        return RL_OK;
    *by = rl_flux_of_point();
    if (!light)
        return RL_OK;
    *by = rl_flux_of_polygon(light->area, 2);
    if (kind != RL_LIGHT_MESH)
        return RL_OK;
    *by = rl_flux_of_body(4.0 * light->area); /* which is a quarter of its surface */
    rl_yaml_key(path, key, quantities[quantity].key);
    if (!light->closed)
        return rl_yaml_fail(b->tree, b->error, path,
                            "found it with an open mesh, which shines from both sides, expected a closed "
                            "one (each edge on two triangles), or luminance");
    return RL_OK;
}

int rl_build_strength(const struct rl_scene_builder *b, size_t i, enum rl_light_kind kind,
                      const struct rl_light *light, double rgb[3])
{
    char key[RL_YAML_KEY_MAX], path[RL_YAML_KEY_MAX];
    int quantity = 0;
    double by = 1.0;
    snprintf(key, sizeof key, "lights[%zu]", i);
    int status = find_quantity(b, key, kind, &quantity);
    if (status != RL_OK)
        return status;
    if (!is_photometric(quantity))
        return read_radiometric(b, i, key, quantity, rgb);
    status = read_photometric(b, key, quantity, b->raw->lights[i].colour, rgb);
    if (status == RL_OK)
        status = divisor(b, key, quantity, kind, light, &by);
    for (int c = 0; c < 3 && status == RL_OK; c++) {
        rgb[c] /= by * b->scene->white;
        rl_yaml_key(path, key, quantities[quantity].key);
        /* Also not a number: 0 of no area that is left in double precision. */
        if (!(rgb[c] <= RL_COLOUR_MAX))
            return rl_yaml_fail_value(b->tree, b->error, path, "at most %g times camera.white (%g cd/m2) %s",
                                      RL_COLOUR_MAX, b->scene->white,
                                      light ? "as the luminance that follows" : "in any component");
    }
    return status;
}

/* ---- Of a scene ---- */

/* A strength where it stands. */
struct place {
    bool found;
    size_t light;
    int quantity, line;
};

static const char *name_of(const struct rl_scene_builder *b, const struct place *p, char unnamed[32])
{
    snprintf(unnamed, 32, "lights[%zu]", p->light);
    return b->raw->lights[p->light].name ? b->raw->lights[p->light].name : unnamed;
}

/* The first strength of either kind, [1] the photometric one. */
static void find_places(const struct rl_scene_builder *b, struct place place[2])
{
    char key[RL_YAML_KEY_MAX], path[RL_YAML_KEY_MAX];
    for (size_t i = 0; i < b->raw->n_lights; i++)
        for (int q = 0; q < N_QUANTITIES; q++) {
            snprintf(key, sizeof key, "lights[%zu]", i);
            rl_yaml_key(path, key, quantities[q].key);
            const struct rl_yaml_node *node = rl_yaml_find(b->tree, path);
            if (node && !place[is_photometric(q)].found)
                place[is_photometric(q)] = (struct place){true, i, q, node->line};
        }
}

static int check_mixture(const struct rl_scene_builder *b, const struct place place[2])
{
    /* Both in one light is another error. */
    if (!place[0].found || !place[1].found || place[0].light == place[1].light)
        return RL_OK;
    bool later = place[1].light > place[0].light;
    const struct place *at = &place[later], *with = &place[!later];
    char path[RL_YAML_KEY_MAX], unnamed[2][32];
    snprintf(path, sizeof path, "lights[%zu].%s", at->light, quantities[at->quantity].key);
    return rl_yaml_fail(
        b->tree, b->error, path,
        "found the %s %s of %.64s, and in line %d the %s %s of %.64s, expected all lights of a "
        "scene radiometric or all photometric",
        later ? "photometric" : "radiometric", quantities[at->quantity].key, name_of(b, at, unnamed[0]),
        with->line, later ? "radiometric" : "photometric", quantities[with->quantity].key,
        name_of(b, with, unnamed[1]));
}

int rl_build_white(const struct rl_scene_builder *b)
{
    struct place place[2] = {{.found = false}, {.found = false}};
    char unnamed[32];
    find_places(b, place);
    bool given = rl_build_has_key(b, "camera", "white");
    int status = check_mixture(b, place);
    if (status != RL_OK)
        return status;
    if (given && place[0].found)
        return rl_yaml_fail(b->tree, b->error, "camera.white",
                            "found it, and in line %d the radiometric %s of %.64s, expected it only with "
                            "photometric lights",
                            place[0].line, quantities[place[0].quantity].key, name_of(b, &place[0], unnamed));
    b->scene->white = place[1].found ? WHITE_DEFAULT : 0.0;
    return given ? read_measure(b, "camera.white", &b->scene->white, RL_UNIT_LUMINANCE, WHITE_MIN,
                                "a luminance", "3000 cd/m2")
                 : RL_OK;
}
