/* Shader modules: a mistake in any of them is reported with its file and line. */
#include <dirent.h>
#include <limits.h>

#include "base/files.h"
#include "gpu/fixture.h"
#include "gpu/modules.h"
#include "support/temporary.h"

static struct temporary folder;

static void copied_path(char path[PATH_MAX], const char *module)
{
    int n = snprintf(path, PATH_MAX, "%s/shaders/%s.glsl", folder.folder, module);
    assert_in_range(n, 1, PATH_MAX - 1);
}

/* Copies a module with `line` in place of line `number`; 0: as it is. */
static void copy_module(const char *module, int number, const char *line)
{
    struct rl_error error;
    char path[PATH_MAX];
    char *text;
    size_t size;
    snprintf(path, sizeof path, "shaders/%s.glsl", module);
    check_ok(rl_file_read(&text, &size, path, &error), &error);
    char *copy = malloc(size + strlen(line) + 1);
    assert_non_null(copy);
    const char *start = text;
    for (int i = 1; i < number; i++) {
        start = strchr(start, '\n');
        assert_non_null(start++);
    }
    const char *end = number ? start + strcspn(start, "\n") : start;
    int n = sprintf(copy, "%.*s%s%s", (int)(start - text), text, number ? line : "", end);
    copied_path(path, module);
    check_ok(rl_file_write(path, copy, (size_t)n, &error), &error);
    free(copy);
    free(text);
}

static void restore(const char *module)
{
    copy_module(module, 0, "");
}

static void copy_folder(const char *name)
{
    struct rl_error error;
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/shaders/%s", folder.folder, name);
    check_ok(rl_directory_create(path, &error), &error);
    snprintf(path, sizeof path, "shaders/%s", name);
    DIR *directory = opendir(path);
    assert_non_null(directory);
    for (const struct dirent *entry; (entry = readdir(directory)) != NULL;) {
        char module[300];
        int stem = (int)strcspn(entry->d_name, ".");
        if (stem == 0)
            continue;
        snprintf(module, sizeof module, "%s/%.*s", name, stem, entry->d_name);
        restore(module);
    }
    closedir(directory);
}

static int copy_shaders(void **state)
{
    (void)state;
    static const char *const folders[] = {"common", "effects", "methods", "passes"};
    temporary_make(&folder);
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++)
        copy_folder(folders[i]);
    return setenv("ROUGHLIGHT_DATA", folder.folder, 1);
}

static int remove_shaders(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return unsetenv("ROUGHLIGHT_DATA");
}

static int prepare(const char *method, struct rl_error *error)
{
    struct rl_scene scene;
    struct rl_plan plan;
    struct rl_gpu *gpu;
    struct rl_gpu_scene *gs;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    fixture_sphere(&scene, 32, 24, method, 10.0);
    check_ok(rl_plan_make(&plan, &scene, &settings, error), error);
    check_ok(rl_gpu_open(&gpu, "auto", error), error);
    int status = rl_gpu_scene_make(&gs, gpu, &scene, &plan, error);
    rl_gpu_scene_free(gs);
    rl_gpu_close(gpu);
    rl_plan_clear(&plan);
    fixture_end(&scene);
    return status;
}

static void a_mistake_is_named_by_module_and_line(void **state)
{
    (void)state;
    static const struct {
        const char *module, *method;
        int line;
    } rows[] = {
        {"common/surface", "plain", 4},        {"common/lights", "plain", 7},
        {"effects/ambient", "plain", 7},       {"effects/diffuse", "plain", 9},
        {"methods/plain", "plain", 10},        {"passes/surface", "plain", 9},
        {"passes/object_vertex", "plain", 9},  {"common/frame", "random", 6},
        {"common/environment", "regular", 13}, {"common/normal_map", "random", 10},
        {"methods/regular", "regular", 6},     {"passes/highlight", "random", 9},
        {"passes/environment", "random", 8},
    };
    /* Compilers may report what does not parse and what has no meaning by different ways. */
    static const char *const mistakes[] = {"$ mistake $", "float mistake = not_declared;",
                                           "float mistake = vec3(1.0);"};
    for (size_t j = 0; j < 3 * sizeof rows / sizeof rows[0]; j++) {
        size_t i = j / 3;
        struct rl_error error;
        char expected[128];
        copy_module(rows[i].module, rows[i].line, mistakes[j % 3]);
        assert_int_equal(prepare(rows[i].method, &error), RL_ERR_INPUT);
        restore(rows[i].module);
        snprintf(expected, sizeof expected, "shaders/%s.glsl:%d: ", rows[i].module, rows[i].line);
        if (strncmp(error.message, expected, strlen(expected)) != 0)
            fail_msg("expected %s..., found %s", expected, error.message);
        assert_null(strchr(error.message, '\n'));
    }
    struct rl_error error;
    check_ok(prepare("random", &error), &error);
}

static void a_missing_function_is_named(void **state)
{
    (void)state;
    struct rl_error error;
    copy_module("effects/diffuse", 7, "vec3 effect_other(Surface s, vec3 L, vec4 params[1])");
    assert_int_equal(prepare("plain", &error), RL_ERR_INPUT);
    restore("effects/diffuse");
    assert_non_null(strstr(error.message, "reflect_diffuse"));
}

static void a_missing_module_is_an_error(void **state)
{
    (void)state;
    struct rl_error error;
    char path[PATH_MAX];
    copied_path(path, "methods/random");
    assert_int_equal(remove(path), 0);
    check_fails(prepare("random", &error), &error, RL_ERR_UNAVAILABLE, "shaders/methods/random.glsl");
    restore("methods/random");
}

static void logs_of_other_compilers(void **state)
{
    (void)state;
    static const struct {
        const char *log, *expected;
    } rows[] = {
        {"0:20012(3): error: `x' undeclared\n", "shaders/effects/diffuse.glsl:12: error: `x' undeclared"},
        {"0:10001(2): warning: w\n1:20007(3): error: e\n", "shaders/effects/diffuse.glsl:7: error: e"},
        {"0(20012) : error C1008: undefined variable\n",
         "shaders/effects/diffuse.glsl:12: error C1008: undefined variable"},
        {"ERROR: 0:10003: 'x' : undeclared identifier\n",
         "shaders/passes/object_vertex.glsl:3: 'x' : undeclared identifier"},
        {"error: unresolved reference to function `highlight'\n",
         "the surface pass's shader: error: unresolved reference to function `highlight'"},
        {"", "the surface pass's shader: "},
    };
    struct rl_plan_program program = {.pass = "surface", .n_modules = 2};
    snprintf(program.module[0], sizeof program.module[0], "passes/object_vertex");
    snprintf(program.module[1], sizeof program.module[1], "effects/diffuse");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct rl_error error;
        assert_int_equal(rl_modules_fail(&program, rows[i].log, &error), RL_ERR_INPUT);
        assert_string_equal(error.message, rows[i].expected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mistake_is_named_by_module_and_line),
        cmocka_unit_test(a_missing_function_is_named),
        cmocka_unit_test(a_missing_module_is_an_error),
        cmocka_unit_test(logs_of_other_compilers),
    };
    return cmocka_run_group_tests(tests, copy_shaders, remove_shaders);
}
