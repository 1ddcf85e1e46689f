/* What `plan --format json` says that is uploaded, allocated and drawn is what the GL layer counts when the plan is carried out. */
#include <sys/wait.h>

#include "gpu/context.h"
#include "gpu/fixture.h"

static struct rl_gpu *gpu;

/* The options of a plan, and the settings that they are. */
struct variant {
    const char *options;
    void (*set)(struct rl_settings *settings);
};

static void set_nothing(struct rl_settings *s)
{
    (void)s;
}

static void set_small(struct rl_settings *s)
{
    s->normal_bits = 12;
    s->normal_size = 64;
    s->env_size = 16;
    s->env_format = RL_TEXEL_RGBA16F;
    s->depth_bits = 32;
}

static void set_half(struct rl_settings *s)
{
    s->normal_bits = RL_NORMAL_BITS_HALF;
    s->normal_size = 128;
    s->env_size = 8;
    s->interpolation = RL_INTERPOLATION_CONSTANT;
    s->drop = false;
}

static void set_spheres(struct rl_settings *s)
{
    s->margin_kind = RL_MARGIN_VALUE;
    s->margin = 0.2;
    s->normal_bits = RL_NORMAL_BITS_FLOAT;
    s->normal_size = 64;
}

static void set_plain(struct rl_settings *s)
{
    s->method = "plain";
    s->depth_bits = 16;
    s->interpolation = RL_INTERPOLATION_GOURAUD;
}

static void set_regular(struct rl_settings *s)
{
    s->method = "regular";
    s->samples = 16;
    s->env_format = RL_TEXEL_RGB10A2;
    s->reversed_depth = true;
}

/* All of a small picture. */
static const struct variant variants[] = {
    {"", set_nothing},
    {"--normal-bits 12 --normal-size 64 --env-size 16 --env-format rgba16f --depth-bits 32", set_small},
    {"--normal-bits half --normal-size 128 --env-size 8 --interpolation constant --drop off", set_half},
    {"--margin 0.2 --normal-bits float --normal-size 64", set_spheres},
    {"--method plain --depth-bits 16 --interpolation gouraud", set_plain},
    {"--method regular --samples 16 --env-format rgb10a2 --reversed-depth on", set_regular},
};

/* ---- What is said ---- */

/* The number after this key in the line of a row; -1 where the row has no such key, or null. */
static long long number_of(const char *line, const char *key)
{
    char text[64];
    snprintf(text, sizeof text, "\"%s\": ", key);
    const char *at = strstr(line, text);
    return at && at[strlen(text)] != 'n' ? strtoll(at + strlen(text), NULL, 10) : -1;
}

static bool has(const char *line, const char *key, const char *value)
{
    char text[128];
    snprintf(text, sizeof text, "\"%s\": \"%s\"", key, value);
    return strstr(line, text) != NULL;
}

struct said {
    struct rl_gpu_counters made, frame;
    size_t image_bytes; /* of textures and render buffers */
};

static void add_row(struct said *said, const char *line)
{
    long long uploaded = number_of(line, "uploaded_bytes");
    said->made.bytes_uploaded += uploaded > 0 ? (size_t)uploaded : 0;
    said->made.textures += has(line, "resource", "texture");
    said->made.renderbuffers += has(line, "resource", "renderbuffer");
    if (has(line, "resource", "texture") || has(line, "resource", "renderbuffer"))
        said->image_bytes += (size_t)number_of(line, "bytes");
    said->made.modules += has(line, "kind", "module");
    long long draws = number_of(line, "draws");
    if (!has(line, "kind", "pass") || has(line, "pass", "cpu"))
        return;
    assert_true(draws > 0 && (has(line, "each", "scene") || has(line, "each", "frame")));
    if (has(line, "each", "scene"))
        said->made.draws += (size_t)draws;
    else
        said->frame.draws += (size_t)draws;
    said->made.programs++;
}

/* False: bad usage, an option that would have no effect on the scene. */
static bool ask(struct said *said, const char *path, const char *options)
{
    const char *program = getenv("ROUGHLIGHT");
    char command[512];
    static char line[1 << 16];
    *said = (struct said){.made = {0}};
    snprintf(command, sizeof command, "%s plan %s --format json --size 64x48 %s 2>/dev/null",
             program ? program : "build/roughlight", path, options);
    FILE *rows = popen(command, "r"); /* NOLINT(cert-env33-c): a command of this test's making */
    assert_non_null(rows);
    while (fgets(line, sizeof line, rows))
        add_row(said, line);
    int status = pclose(rows);
    assert_true(WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 2));
    return WEXITSTATUS(status) == 0;
}

/* ---- What is so ---- */

/* The functions that calls go on to, and the bytes of all storage that was asked for. */
static struct rl_gl behind;
static size_t stored;

/* OpenGL 4.5, tables 8.12 and 8.13; depth without stencil in whole words. */
static size_t bytes_of(GLenum format)
{
    static const struct {
        GLenum format;
        size_t bytes;
    } all[] = {
        {GL_RGBA8, 4},
        {GL_RGB10_A2, 4},
        {GL_RGBA16, 8},
        {GL_RGBA16F, 8},
        {GL_RGBA32F, 16},
        {GL_DEPTH_COMPONENT16, 2},
        {GL_DEPTH_COMPONENT24, 4},
        {GL_DEPTH_COMPONENT32F, 4},
        {GL_DEPTH24_STENCIL8, 4},
        {GL_DEPTH32F_STENCIL8, 8},
    };
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
        if (all[i].format == format)
            return all[i].bytes;
    fail_msg("a format of 0x%x, which the test does not know", format);
    return 0;
}

static void APIENTRY store_texture(GLenum target, GLsizei levels, GLenum format, GLsizei width,
                                   GLsizei height)
{
    assert_int_equal(levels, 1);
    stored += bytes_of(format) * (size_t)width * (size_t)height * (target == GL_TEXTURE_CUBE_MAP ? 6 : 1);
    behind.TexStorage2D(target, levels, format, width, height);
}

static void APIENTRY store_renderbuffer(GLenum target, GLenum format, GLsizei width, GLsizei height)
{
    stored += bytes_of(format) * (size_t)width * (size_t)height;
    behind.RenderbufferStorage(target, format, width, height);
}

static int open_gpu(void **state)
{
    (void)state;
    struct rl_error error;
    int status = rl_gpu_open(&gpu, "auto", &error);
    if (status != RL_OK)
        return status;
    behind = gpu->gl;
    gpu->gl.TexStorage2D = store_texture;
    gpu->gl.RenderbufferStorage = store_renderbuffer;
    return RL_OK;
}

static int close_gpu(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    return 0;
}

static void compare(const char *path, const char *options, struct rl_gpu_scene *gs, const struct said *said)
{
    struct rl_error error;
    struct rl_gpu_counters made = rl_gpu_scene_counters(gs);
    double seconds;
    rl_gpu_scene_reset_counters(gs);
    check_ok(rl_gpu_scene_frame(gs, &seconds, &error), &error);
    struct rl_gpu_counters frame = rl_gpu_scene_counters(gs);
    if (made.bytes_uploaded != said->made.bytes_uploaded)
        fail_msg("%s %s: %zu bytes uploaded, the plan says %zu", path, options, made.bytes_uploaded,
                 said->made.bytes_uploaded);
    assert_int_equal(stored, said->image_bytes);
    assert_int_equal(made.textures, said->made.textures);
    assert_int_equal(made.renderbuffers, said->made.renderbuffers);
    assert_int_equal(made.programs, said->made.programs);
    assert_int_equal(made.modules, said->made.modules);
    assert_int_equal(made.draws, said->made.draws);
    assert_int_equal(frame.draws, said->frame.draws);
    assert_int_equal(frame.bytes_uploaded, 0);
}

/* Whether there was something to compare. */
static bool check(const char *path, const struct variant *variant)
{
    struct rl_error error;
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_gpu_scene *gs = NULL;
    struct said said;
    if (!ask(&said, path, variant->options))
        return false;
    check_ok(rl_scene_load(&scene, path, &error), &error);
    struct rl_settings settings = scene.settings;
    variant->set(&settings);
    settings.width = 64;
    settings.height = 48;
    rl_scene_fit_planes(&scene, settings.width, settings.height);
    check_ok(rl_plan_make(&plan, &scene, &settings, &error), &error);
    if (plan.on_cpu) {
        const struct rl_gpu_counters none = {0};
        assert_memory_equal(&said.made, &none, sizeof none);
        assert_memory_equal(&said.frame, &none, sizeof none);
    } else {
        rl_kept_clear(&gpu->kept, &gpu->gl);
        stored = 0;
        check_ok(rl_gpu_scene_make(&gs, gpu, &scene, &plan, &error), &error);
        compare(path, variant->options, gs, &said);
        rl_gpu_scene_free(gs);
    }
    rl_plan_clear(&plan);
    rl_scene_clear(&scene);
    return true;
}

static void test_scenes(void **state)
{
    (void)state;
    static const char *const scenes[] = {
        "ball-shadow", "everything", "facets",      "fur",         "glass",        "lamps",         "layers",
        "metals",      "office",     "sphere-quad", "teapot-star", "three-lights", "two-roughness", "window",
    };
    for (size_t k = 0; k < sizeof variants / sizeof variants[0]; k++) {
        int n = 0;
        for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
            char path[64];
            snprintf(path, sizeof path, "studies/scenes/%s.yaml", scenes[i]);
            n += check(path, &variants[k]);
        }
        print_message("%d scenes with '%s'\n", n, variants[k].options);
        assert_true(n >= 5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_scenes)};
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
