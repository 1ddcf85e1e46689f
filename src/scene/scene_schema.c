/* The tables that define scene files, and the loading of one (see scene_schema.h). */
#include "scene/scene_schema.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

#include "scene/effect_schema.h"

enum { TEXT_MAX = 64, FILE_NAME_MAX = 1024, LIST_MAX = 1024, POLYGON_LIST_MAX = 100000 };

#define OPTIONAL CYAML_FLAG_OPTIONAL
#define REQUIRED CYAML_FLAG_DEFAULT

static const cyaml_schema_value_t number = {CYAML_VALUE_FLOAT(CYAML_FLAG_DEFAULT, double)};
static const cyaml_schema_value_t triple = {
    CYAML_VALUE_SEQUENCE_FIXED(CYAML_FLAG_DEFAULT, double, &number, 3)};

#define FIELD_TRIPLE(key, structure, member)                                                                 \
    CYAML_FIELD_SEQUENCE_FIXED(key, REQUIRED, structure, member, &number, 3)
#define FIELD_TRIPLE_PTR(key, structure, member)                                                             \
    CYAML_FIELD_SEQUENCE_FIXED(key, OPTIONAL | CYAML_FLAG_POINTER, structure, member, &number, 3)
#define FIELDS_PLACEMENT(structure)                                                                          \
    CYAML_FIELD_FLOAT_PTR("scale", OPTIONAL, structure, placement.scale),                                    \
        FIELD_TRIPLE_PTR("stretch", structure, placement.stretch),                                           \
        FIELD_TRIPLE_PTR("rotate", structure, placement.rotate),                                             \
        FIELD_TRIPLE_PTR("translate", structure, placement.translate)

static const cyaml_schema_field_t film_fields[] = {
    CYAML_FIELD_INT("width", REQUIRED, struct rl_raw_film, width),
    CYAML_FIELD_INT("height", REQUIRED, struct rl_raw_film, height),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t camera_fields[] = {
    FIELD_TRIPLE("position", struct rl_raw_camera, position),
    FIELD_TRIPLE("target", struct rl_raw_camera, target),
    FIELD_TRIPLE_PTR("up", struct rl_raw_camera, up),
    CYAML_FIELD_FLOAT("field-of-view", REQUIRED, struct rl_raw_camera, field_of_view),
    CYAML_FIELD_FLOAT_PTR("near", OPTIONAL, struct rl_raw_camera, near),
    CYAML_FIELD_FLOAT_PTR("far", OPTIONAL, struct rl_raw_camera, far),
    CYAML_FIELD_IGNORE("white", OPTIONAL),
    CYAML_FIELD_END,
};

static const cyaml_strval_t interpolations[] = {
    {"phong", RL_INTERPOLATION_PHONG},
    {"gouraud", RL_INTERPOLATION_GOURAUD},
    {"constant", RL_INTERPOLATION_CONSTANT},
};

/* Before those of effects, which effect_schema.c appends. */
static const cyaml_schema_field_t material_fields[] = {
    CYAML_FIELD_STRING_PTR("name", CYAML_FLAG_POINTER, struct rl_raw_material, name, 1, TEXT_MAX),
    CYAML_FIELD_FLOAT_PTR("rr", OPTIONAL, struct rl_raw_material, rr),
    FIELD_TRIPLE_PTR("specular", struct rl_raw_material, specular),
    CYAML_FIELD_STRING_PTR("highlight", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_material, highlight, 1,
                           TEXT_MAX),
    CYAML_FIELD_ENUM_PTR("interpolation", CYAML_FLAG_STRICT | OPTIONAL, struct rl_raw_material, interpolation,
                         interpolations, sizeof interpolations / sizeof interpolations[0]),
};

static const cyaml_strval_t shapes[] = {
    {"sphere", RL_SHAPE_SPHERE}, {"torus", RL_SHAPE_TORUS},   {"plane", RL_SHAPE_PLANE},
    {"disc", RL_SHAPE_DISC},     {"teapot", RL_SHAPE_TEAPOT}, {"mesh", RL_SHAPE_MESH},
};

static const cyaml_schema_field_t object_fields[] = {
    CYAML_FIELD_STRING_PTR("name", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_object, name, 1, TEXT_MAX),
    CYAML_FIELD_ENUM("shape", CYAML_FLAG_STRICT, struct rl_raw_object, shape, shapes,
                     sizeof shapes / sizeof shapes[0]),
    CYAML_FIELD_STRING_PTR("file", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_object, file, 1,
                           FILE_NAME_MAX),
    CYAML_FIELD_STRING_PTR("material", CYAML_FLAG_POINTER, struct rl_raw_object, material, 1, TEXT_MAX),
    CYAML_FIELD_INT_PTR("tessellation", OPTIONAL, struct rl_raw_object, tessellation),
    CYAML_FIELD_FLOAT_PTR("minor", OPTIONAL, struct rl_raw_object, minor),
    FIELDS_PLACEMENT(struct rl_raw_object),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t light_fields[] = {
    CYAML_FIELD_STRING_PTR("name", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_light, name, 1, TEXT_MAX),
    /* Longer lists than a polygon may have are let through here: the polygon's own check says what is
     * wrong. */
    CYAML_FIELD_SEQUENCE_COUNT("polygon", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_light, polygon,
                               n_polygon, &triple, 0, POLYGON_LIST_MAX),
    CYAML_FIELD_STRING_PTR("mesh", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_light, mesh, 1,
                           FILE_NAME_MAX),
    FIELDS_PLACEMENT(struct rl_raw_light),
    FIELD_TRIPLE_PTR("position", struct rl_raw_light, position),
    FIELD_TRIPLE_PTR("direction", struct rl_raw_light, direction),
    /* Which of them is needed follows from the kind of light, which this table cannot say. */
    FIELD_TRIPLE_PTR("radiance", struct rl_raw_light, radiance),
    FIELD_TRIPLE_PTR("intensity", struct rl_raw_light, intensity),
    FIELD_TRIPLE_PTR("irradiance", struct rl_raw_light, irradiance),
    CYAML_FIELD_IGNORE("luminance", OPTIONAL),
    CYAML_FIELD_IGNORE("luminous-intensity", OPTIONAL),
    CYAML_FIELD_IGNORE("flux", OPTIONAL),
    CYAML_FIELD_IGNORE("flux-per-side", OPTIONAL),
    CYAML_FIELD_IGNORE("illuminance", OPTIONAL),
    FIELD_TRIPLE_PTR("colour", struct rl_raw_light, colour),
    CYAML_FIELD_END,
};

/* As on the command line, or as YAML has it. */
static const cyaml_strval_t switches[] = {
    {"on", RL_RAW_ON}, {"off", RL_RAW_OFF}, {"true", RL_RAW_ON}, {"false", RL_RAW_OFF}};

static const cyaml_schema_field_t render_fields[] = {
    CYAML_FIELD_INT_PTR("samples", OPTIONAL, struct rl_raw_render, samples),
    CYAML_FIELD_STRING_PTR("normal-bits", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_render, normal_bits, 1,
                           TEXT_MAX),
    CYAML_FIELD_INT_PTR("normal-size", OPTIONAL, struct rl_raw_render, normal_size),
    CYAML_FIELD_INT_PTR("env-size", OPTIONAL, struct rl_raw_render, env_size),
    CYAML_FIELD_STRING_PTR("env-format", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_render, env_format, 1,
                           TEXT_MAX),
    CYAML_FIELD_STRING_PTR("margin", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_render, margin, 1,
                           TEXT_MAX),
    CYAML_FIELD_ENUM_PTR("attenuation", CYAML_FLAG_STRICT | OPTIONAL, struct rl_raw_render, attenuation,
                         switches, sizeof switches / sizeof switches[0]),
    CYAML_FIELD_ENUM_PTR("shadows", CYAML_FLAG_STRICT | OPTIONAL, struct rl_raw_render, shadows, switches,
                         sizeof switches / sizeof switches[0]),
    CYAML_FIELD_ENUM_PTR("culling", CYAML_FLAG_STRICT | OPTIONAL, struct rl_raw_render, culling, switches,
                         sizeof switches / sizeof switches[0]),
    CYAML_FIELD_INT_PTR("depth-bits", OPTIONAL, struct rl_raw_render, depth_bits),
    CYAML_FIELD_ENUM_PTR("reversed-depth", CYAML_FLAG_STRICT | OPTIONAL, struct rl_raw_render, reversed_depth,
                         switches, sizeof switches / sizeof switches[0]),
    CYAML_FIELD_STRING_PTR("frame", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_render, frame, 1, TEXT_MAX),
    CYAML_FIELD_UINT_PTR("seed", OPTIONAL, struct rl_raw_render, seed),
    CYAML_FIELD_FLOAT_PTR("tolerance", OPTIONAL, struct rl_raw_render, tolerance),
    CYAML_FIELD_END,
};

static const cyaml_schema_value_t object = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct rl_raw_object, object_fields)};
static const cyaml_schema_value_t light = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct rl_raw_light, light_fields)};

/* The schema of a whole scene. What materials may hold follows from the table of effects, so it is put together when it is used. */
struct schema {
    cyaml_schema_field_t material_field[RL_MATERIAL_FIELDS_MAX], scene_field[8];
    struct rl_effect_schema effect;
    cyaml_schema_value_t material, scene;
};

static void make_schema(struct schema *s)
{
    enum { N_MATERIAL = sizeof material_fields / sizeof material_fields[0] };
    memset(s, 0, sizeof *s);
    memcpy(s->material_field, material_fields, sizeof material_fields);
    rl_effect_schema_make(&s->effect, s->material_field + N_MATERIAL, RL_MATERIAL_FIELDS_MAX - N_MATERIAL);
    s->material = (cyaml_schema_value_t){
        CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, struct rl_raw_material, s->material_field)};
    const cyaml_schema_field_t scene_fields[] = {
        CYAML_FIELD_MAPPING_PTR("film", OPTIONAL, struct rl_raw_scene, film, film_fields),
        CYAML_FIELD_MAPPING("camera", REQUIRED, struct rl_raw_scene, camera, camera_fields),
        CYAML_FIELD_SEQUENCE_COUNT("materials", CYAML_FLAG_POINTER, struct rl_raw_scene, materials,
                                   n_materials, &s->material, 1, LIST_MAX),
        CYAML_FIELD_SEQUENCE_COUNT("objects", CYAML_FLAG_POINTER, struct rl_raw_scene, objects, n_objects,
                                   &object, 1, LIST_MAX),
        CYAML_FIELD_SEQUENCE_COUNT("lights", CYAML_FLAG_POINTER | OPTIONAL, struct rl_raw_scene, lights,
                                   n_lights, &light, 0, LIST_MAX),
        CYAML_FIELD_MAPPING_PTR("render", OPTIONAL, struct rl_raw_scene, render, render_fields),
        CYAML_FIELD_END,
    };
    static_assert(sizeof scene_fields <= sizeof s->scene_field, "a scene has room for its keys");
    memcpy(s->scene_field, scene_fields, sizeof scene_fields);
    s->scene =
        (cyaml_schema_value_t){CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, struct rl_raw_scene, s->scene_field)};
}

/* Keeps libcyaml's first line, without its newline. */
static void log_line(cyaml_log_t level, void *context, const char *format, va_list arguments)
{
    (void)level;
    char *line = context;
    if (line[0] != '\0')
        return;
    vsnprintf(line, 256, format, arguments);
    line[strcspn(line, "\n")] = '\0';
}

static cyaml_config_t configure(char line[256])
{
    line[0] = '\0';
    return (cyaml_config_t){
        .log_fn = log_line,
        .log_ctx = line,
        .log_level = CYAML_LOG_ERROR,
        .mem_fn = cyaml_mem,
        .flags = CYAML_CFG_NO_ALIAS,
    };
}

int rl_raw_scene_load(struct rl_raw_scene **raw, struct rl_yaml_tree *tree, const char *path,
                      const char *text, size_t size, struct rl_error *error)
{
    *raw = NULL;
    struct schema schema;
    make_schema(&schema);
    int status = rl_yaml_parse(tree, path, text, size, error);
    if (status == RL_OK)
        status = rl_yaml_check(tree, &schema.scene, error);
    if (status != RL_OK)
        return status;
    char line[256];
    cyaml_config_t config = configure(line);
    cyaml_err_t result =
        cyaml_load_data((const uint8_t *)text, size, &config, &schema.scene, (cyaml_data_t **)raw, NULL);
    if (result == CYAML_ERR_OOM)
        return rl_fail_memory(error, path);
    if (result != CYAML_OK)
        return rl_yaml_fail(tree, error, "", "found what libcyaml does not load (%s; %s)",
                            cyaml_strerror(result), line);
    return RL_OK;
}

void rl_raw_scene_free(struct rl_raw_scene *raw)
{
    char line[256];
    struct schema schema;
    cyaml_config_t config = configure(line);
    make_schema(&schema);
    cyaml_free(&config, &schema.scene, raw, 0);
}
