/* Every way a scene file can be wrong that the format knows of: one line that names file, line, key, what
 * was found and what was expected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "scene/wrong.h"

static void test_structure(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        AT(9, "    shine: 30",
           "materials[0]: found the unknown key 'shine', expected name, rr, specular, highlight, "
           "interpolation, ambient"),
        AT(1, "Film: {width: 64, height: 48}", "scene: found the unknown key 'Film', expected film, camera,"),
        AT(34, "  spp: 4", "render: found the unknown key 'spp', expected samples, normal-bits,"),
        AT(3, "  \"po\\nsition\": [0, 1, 5]",
           "camera: found the unknown key 'po\\x0asition', expected position"),
        {6, 6, "", 2, "camera.field-of-view: found nothing, expected a finite number"},
        {8, 8, "  - rr: 10", 9, "YAML: found the key 'rr' again (first in line 8), expected each key once"},
        {7, 13, "materials: []", 7, "materials: found a list of 0, expected a list of 1 to 1024"},
        {14, 22, "objects: []", 14, "objects: found a list of 0, expected a list of 1 to 1024"},
        {14, 22, "", 1, "objects: found nothing, expected a list of 1 to 1024"},
        {14, 22, "objects: none", 14, "objects: found 'none', expected a list of 1 to 1024"},
        {15, 15, "  - 5", 16, "YAML: found a syntax error ("},
        {2, 6, "camera: 5", 2, "camera: found '5', expected a mapping"},
        {2, 6, "camera:", 2, "camera: found nothing, expected a mapping"},
        {26, 26, "", 24,
         "lights[0]: found no strength, expected radiance, luminance, luminous-intensity, flux "},
        AT(26, "    radiance: [1, 1]", "lights[0].radiance: found a list of 2, expected a list of 3"),
        AT(26, "    radiance: 1", "lights[0].radiance: found '1', expected a list of 3"),
        AT(30, "      - [3, 1]", "lights[1].polygon[1]: found a list of 2, expected a list of 3"),
        AT(30, "      - [3, 1, {a: 1}]",
           "lights[1].polygon[1][2]: found a mapping, expected a finite number"),
        {0, -1, "---\nfilm: {}", 36, "YAML: found a second document, expected one"},
        {4, 4, "  target: &here [0, 0, 0]\n  up: *here", 5,
         "YAML: found an alias, expected values written out"},
        AT(4, "  target: [[[[[[[[[[[[[[[[[[0]]]]]]]]]]]]]]]]]]",
           "YAML: found lists or mappings more than 16"),
        AT(4, "\ttarget: [0, 0, 0]", "YAML: found a syntax error (found character that cannot"),
        {4, 4, "  target: [0, 0, 0", 5, "YAML: found a syntax error (did not find expected ',' or ']'"},
        AT(4, "  target: \"a\\0b\"", "YAML: found a NUL character, expected text"),
        AT(4, "  ? [a]\n  : 1", "YAML: found a key that is no word, expected plain keys"),
    };
    CHECK_ALL(table);
}

static void test_numbers(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        AT(9, "    rr: nan", "materials[0].rr: found 'nan', expected a finite number"),
        AT(9, "    rr: .nan", "materials[0].rr: found '.nan', expected a finite number"),
        AT(9, "    rr: .inf", "materials[0].rr: found '.inf', expected a finite number"),
        AT(9, "    rr: inf", "materials[0].rr: found 'inf', expected a finite number"),
        AT(9, "    rr: 1e400", "materials[0].rr: found '1e400', expected a finite number"),
        AT(9, "    rr: 1e-400", "materials[0].rr: found '1e-400', expected a finite number"),
        AT(9, "    rr: 0x10", "materials[0].rr: found '0x10', expected a finite number"),
        AT(9, "    rr: 30 40", "materials[0].rr: found '30 40', expected a finite number"),
        AT(9, "    rr: smooth", "materials[0].rr: found 'smooth', expected a finite number"),
        AT(9, "    rr: ''", "materials[0].rr: found nothing, expected a finite number"),
        AT(9, "    rr: \"a\\nb\\u00e9\"",
           "materials[0].rr: found 'a\\x0ab\\xc3\\xa9', expected a finite number"),
        AT(9, "    rr: -1", "materials[0].rr: found '-1', expected 1e-06 to 1e+12"),
        AT(9, "    rr: 0", "materials[0].rr: found '0', expected 1e-06 to 1e+12"),
        AT(9, "    rr: 1e13", "materials[0].rr: found '1e13', expected 1e-06 to 1e+12"),
        AT(1, "film: {width: 64.5, height: 48}", "film.width: found '64.5', expected a whole number"),
        AT(1, "film: {width: 010, height: 48}", "film.width: found '010', expected a whole number"),
        AT(1, "film: {width: 99999999999, height: 48}", "film.width: found '99999999999', expected a whole"),
        AT(1, "film: {width: 64, height: 0}", "film.height: found '0', expected 1 to 16384"),
        AT(1, "film: {width: 20000, height: 48}", "film.width: found '20000', expected 1 to 16384"),
        AT(34, "  samples: 0", "render.samples: found '0', expected 1 to 1024"),
        AT(34, "  samples: 100000", "render.samples: found 100000, expected 1 to 1024"),
        AT(34, "  seed: -1", "render.seed: found '-1', expected a whole number from 0"),
        AT(34, "  seed: 18446744073709551616", "render.seed: found '18446744073709551616', expected a whole"),
        AT(34, "  normal-bits: 3", "render.normal-bits: found '3', expected 4 to 16, half or float"),
        AT(34, "  normal-size: 100",
           "render.normal-size: found 100, expected a power of two from 64 to 2048"),
        AT(34, "  env-size: 7", "render.env-size: found 7, expected 8 to 4096"),
        AT(34, "  env-format: rgb", "render.env-format: found 'rgb', expected rgba8,"),
        AT(35, "  margin: -1",
           "render.margin: found '-1', expected off, auto, auto:BOUND or a number from 0 to 1e6"),
        AT(35, "  margin: auto:1",
           "render.margin: found 'auto:1', expected a bound from 1e-6 to 0.999 behind auto:"),
        AT(35, "  attenuation: maybe", "render.attenuation: found 'maybe', expected on, off, true or false"),
        AT(35, "  frame: wooden", "render.frame: found 'wooden', expected orthonormal or printed"),
        AT(35, "  tolerance: 0", "render.tolerance: found 0, expected 1e-12 to 0.1"),
        AT(34, "  depth-bits: 8", "render.depth-bits: found 8, expected 16, 24 or 32"),
        AT(34, "  depth-bits: deep", "render.depth-bits: found 'deep', expected a whole number"),
        AT(34, "  culling: front", "render.culling: found 'front', expected on, off, true or false"),
        AT(34, "  reversed-depth: 1", "render.reversed-depth: found '1', expected on, off, true or false"),
    };
    CHECK_ALL(table);
}

static void test_camera(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        AT(4, "  target: [0, 1, 5]",
           "camera.target: found the camera's own position, expected a point to look at"),
        AT(5, "  up: [0, -1, -5]",
           "camera.up: found the view direction parallel to up (0, -1, -5), expected"),
        AT(5, "  up: [0, 0, 0]", "camera.up: found the view direction parallel to up (0, 0, 0)"),
        {4, 5, "  target: [0, -9, 5]", 4, "camera.target: found the view direction parallel to up (0, 1, 0)"},
        AT(6, "  field-of-view: 0", "camera.field-of-view: found '0', expected 0.01 to 179"),
        AT(6, "  field-of-view: 180", "camera.field-of-view: found '180', expected 0.01 to 179"),
        AT(3, "  position: [0, 1, 5e9]", "camera.position[2]: found '5e9', expected -1e+09 to 1e+09"),
        {6, 6, "  field-of-view: 40\n  near: 0", 7, "camera.near: found '0', expected 1e-09 to 1e+09"},
        {6, 6, "  field-of-view: 40\n  far: -1", 7, "camera.far: found '-1', expected 1e-09 to 1e+09"},
        {6, 6, "  field-of-view: 40\n  near: .inf", 7, "camera.near: found '.inf', expected a finite number"},
        {6, 6, "  field-of-view: 40\n  near: 3\n  far: 3", 7,
         "camera.near: found '3', expected less than far, 3"},
        {6, 6, "  field-of-view: 40\n  far: 2\n  near: 3", 8,
         "camera.near: found '3', expected less than far, 2"},
        {6, 6, "  field-of-view: 40\n  near: 100", 7, "camera.near: found '100', expected less than 6."},
        {6, 6, "  field-of-view: 40\n  far: 0.01", 7, "camera.far: found '0.01', expected more than 3."},
    };
    CHECK_ALL(table);
}

static void test_materials(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        AT(10, "    diffuse: [0.1, 1.5, 0.3]", "materials[0].diffuse[1]: found '1.5', expected 0 to 1"),
        AT(10, "    specular: [-1, 1, 1]", "materials[0].specular[0]: found '-1', expected 0 to 1e+09"),
        {13, 13, "    ambient:\n      - 0\n      - -2\n      - 0", 15,
         "materials[1].ambient[1]: found '-2', expected 0"},
        AT(11, "    highlight: shiny",
           "materials[0].highlight: found 'shiny', expected plain, regular, random, exhaustive or reference, "
           "or none"),
        {9, 9, "", 8, "materials[0].rr: found nothing, expected the roughness R_r of the highlight"},
        AT(12, "  - name: shiny",
           "materials[1].name: found 'shiny', expected a name of its own, for materials[0]"),
        AT(8, "  - name: ''", "materials[0].name: found nothing, expected a text of 1 to 64 bytes"),
    };
    CHECK_ALL(table);
}

static void test_objects(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        AT(16, "    shape: cube",
           "objects[0].shape: found 'cube', expected sphere, torus, plane, disc, teapot or"),
        AT(17, "    material: gold",
           "objects[0].material: found 'gold', expected the name of one of the 2 mat"),
        AT(18, "    tessellation: 0", "objects[0].tessellation: found '0', expected 1 to 512"),
        AT(18, "    tessellation: 1000", "objects[0].tessellation: found '1000', expected 1 to 512"),
        AT(18, "    minor: 0.5", "objects[0].minor: found it with shape: sphere, expected only with torus"),
        AT(18, "    file: a.ply", "objects[0].file: found it with shape: sphere, expected only with mesh"),
        {16, 18, "    shape: torus\n    material: matt\n    minor: 1", 18,
         "objects[0].minor: found '1', expected 0.001"},
        {16, 16, "    shape: mesh", 15, "objects[0].file: found nothing, expected the name of a mesh file"},
        {16, 18, "    shape: mesh\n    file: a.ply\n    tessellation: 3\n    material: matt", 18,
         "objects[0].tessellation: found it with shape: mesh, expected only with sphere,"},
        AT(18, "    scale: 0", "objects[0].scale: found '0', expected 1e-06 to 1e+06"),
        AT(18, "    scale: -1", "objects[0].scale: found '-1', expected 1e-06 to 1e+06"),
        {18, 18, "    scale: 1e6\n    stretch: [1e6, 1, 1]", 15,
         "objects[0]: found it to reach 1e+12 from the origin"},
        AT(18, "    stretch: [1, 0, 1]", "objects[0].stretch[1]: found '0', expected 1e-06 to 1e+06"),
        AT(18, "    rotate: [1, 2]", "objects[0].rotate: found a list of 2, expected a list of 3"),
        AT(22, "    translate: [0, 1e10, 0]",
           "objects[1].translate[1]: found '1e10', expected -1e+09 to 1e+09"),
        AT(19, "  - name: ball",
           "objects[1].name: found 'ball', expected a name of its own, for objects[0] has it"),
    };
    CHECK_ALL(table);
}

static void test_lights(void **state)
{
    (void)state;
    static const struct wrong table[] = {
        AT(25, "    polygon: [[0, 0, 0], [1, 0, 0]]",
           "lights[0].polygon: found 2 vertices, expected 3 to 64"),
        AT(25, "    polygon: []", "lights[0].polygon: found 0 vertices, expected 3 to 64"),
        {31, 31, "", 28, "lights[1].polygon: found 2 vertices, expected 3 to 64"},
        AT(25, "    polygon: [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]",
           "lights[0].polygon: found vertex 0 off the polygon's plane by 0.204, expected a planar polygon"),
        AT(25, "    polygon: [[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1.5, 0]]",
           "lights[0].polygon: found edges 0 and 2"),
        AT(25, "    polygon: [[0, 0, 0], [1, 1, 1], [2, 2, 2]]",
           "lights[0].polygon: found a polygon of zero area"),
        AT(30, "      - [3, nan, 0]", "lights[1].polygon[1][1]: found 'nan', expected a finite number"),
        AT(30, "      - [3, 1e12, 0]", "lights[1].polygon[1][1]: found '1e12', expected -1e+09 to 1e+09"),
        AT(26, "    radiance: [1, -2, 3]", "lights[0].radiance[1]: found '-2', expected 0 to 1e+09"),
        AT(26, "    radiance: [1, .inf, 3]", "lights[0].radiance[1]: found '.inf', expected a finite number"),
        {25, 25, "", 24,
         "lights[0]: found neither polygon, mesh, position nor direction, expected one of them"},
        {25, 25, "    position: [0, 0, 1]\n    direction: [0, 0, 1]", 24,
         "lights[0]: found position and direction, expected one of them"},
        {25, 25, "    position: [0, 0, 1]", 26,
         "lights[0].radiance: found it with position, expected intensity"},
        {25, 25, "    direction: [0, 0, 1]", 26,
         "lights[0].radiance: found it with direction, expected irradiance"},
        {26, 26, "    intensity: [1, 1, 1]", 26,
         "lights[0].intensity: found it with polygon, expected radiance"},
        {26, 26, "    radiance: [1, 1, 1]\n    irradiance: [1, 1, 1]", 27,
         "lights[0].irradiance: found it with polygon, expected radiance"},
        {25, 26, "    position: [0, 0, 1]", 24,
         "lights[0]: found no strength, expected intensity, luminous-intensity or flux"},
        {25, 26, "    position: [0, 0, 1]\n    intensity: [1, -1, 1]", 26,
         "lights[0].intensity[1]: found '-1', expected 0 to 1e+09"},
        {25, 26, "    position: [0, 0, 1e10]\n    intensity: [1, 1, 1]", 25,
         "lights[0].position[2]: found '1e10', expected -1e+09 to 1e+09"},
        {25, 26, "    direction: [0, 0, 0]\n    irradiance: [1, 1, 1]", 25,
         "lights[0].direction: found the zero vector, expected where the light goes"},
        {25, 26, "    direction: [0, 0, 1]\n    irradiance: [1, 1, 1]\n    rotate: [0, 0, 1]", 27,
         "lights[0].rotate: found it with direction, expected only with polygon or mesh"},
        AT(24, "  - mesh: a.ply", "lights[0]: found polygon and mesh, expected one of them"),
        AT(27, "  - name: quad",
           "lights[1].name: found 'quad', expected a name of its own, for lights[0] has it"),
        {26, 26, "    radiance: [1, 2, 3]\n    scale: 0", 27,
         "lights[0].scale: found '0', expected 1e-06 to 1e+06"},
    };
    CHECK_ALL(table);
    static char many[4096];
    size_t length = (size_t)snprintf(many, sizeof many, "    polygon: [");
    for (int i = 0; i < 65; i++)
        length +=
            (size_t)snprintf(many + length, sizeof many - length, "%s[%d, %d, 0]", i ? ", " : "", i, i * i);
    snprintf(many + length, sizeof many - length, "]");
    const struct wrong too_many[] = {AT(25, many, "lights[0].polygon: found 65 vertices, expected 3 to 64")};
    CHECK_ALL(too_many);
}

static void write_text(const char *name, const char *text, size_t size)
{
    char path[PATH_MAX];
    temporary_path(&folder, path, name);
    put_file(path, text, size);
}

/* The message has the scene's line and key, and the mesh file's own. */
static void test_meshes(void **state)
{
    (void)state;
    static const char cut[] =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
        "0 0 0\n1 0 0\n";
    static const char flat[] = "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
    static const char far[] = "v 0 0 0\nv 1e10 0 0\nv 0 1 0\nf 1 2 3\n";
    write_text("cut.ply", cut, sizeof cut - 1);
    write_text("empty.obj", "", 0);
    write_text("flat.obj", flat, sizeof flat - 1);
    write_text("far.obj", far, sizeof far - 1);
    char path[PATH_MAX];
    temporary_path(&folder, path, "folder.obj");
    assert_int_equal(mkdir(path, 0777), 0);
    static const struct {
        const char *file, *message;
    } cases[] = {
        {"none.ply", "/none.ply: cannot open: No such file or directory"},
        {"cut.ply", "/cut.ply: found a file cut off after 2 of 3 rows of vertex, expected all of them"},
        {"empty.obj", "/empty.obj: found an empty file, expected a mesh"},
        {"flat.obj", "/flat.obj: found only triangles without area, expected a mesh"},
        {"far.obj", "found the coordinate 1e+10 in the mesh, expected at most 1e+09"},
        {"folder.obj", "/folder.obj: not a regular file"},
    };
    temporary_path(&folder, path, "scene.yaml");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[256], place[64];
        snprintf(text, sizeof text, "    shape: mesh\n    file: %s\n    material: matt", cases[i].file);
        write_scene(path, 16, 18, text);
        struct rl_scene scene;
        check_fails(rl_scene_load(&scene, path, &error), &error, RL_ERR_INPUT, cases[i].message);
        snprintf(place, sizeof place, "scene.yaml:17: objects[0].file: ");
        assert_non_null(strstr(error.message, place));
    }
    write_scene(path, 25, 25, "    mesh: flat.obj");
    struct rl_scene scene;
    check_fails(rl_scene_load(&scene, path, &error), &error, RL_ERR_INPUT, "scene.yaml:25: lights[0].mesh: ");
}

/* What is no scene at all. */
static void test_files(void **state)
{
    (void)state;
    struct rl_scene scene;
    char path[PATH_MAX];
    temporary_path(&folder, path, "none.yaml");
    check_fails(rl_scene_load(&scene, path, &error), &error, RL_ERR_INPUT,
                "none.yaml: cannot open: No such file");
    check_fails(rl_scene_load(&scene, folder.folder, &error), &error, RL_ERR_INPUT, "not a regular file");
    check_fails(rl_scene_load(&scene, "", &error), &error, RL_ERR_INPUT, "cannot open");

    enum { BIG = 50000000 };
    char *junk = malloc(BIG);
    assert_non_null(junk);
    static const struct {
        const char *fill; /* repeated */
        size_t size;
        const char *message;
    } cases[] = {
        {"", 0, ":1: YAML: found an empty file, expected a scene"},
        {"# nothing\n", 40, "YAML: found an empty file, expected a scene"},
        {"\x7f\x45\x4c\x46\x02\x01", 600,
         ":1: YAML: found a syntax error (control characters are not allowed)"},
        {"\x80\x81", 600, ":1: YAML: found a syntax error"},
        {"a", BIG, ":1: YAML: found a file of 50000000 bytes, expected a scene of at most 4 MiB"},
        {"[", 4000000, ":1: YAML: found lists or mappings more than 16 levels deep"},
        {"{a: ", 4000000, ":1: YAML: found lists or mappings more than 16 levels deep"},
        {"a", 4000000, ":1: scene: found 'aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa...', expected a mapping"},
        {"- a\n", 400000, ":1: scene: found a list of 100000, expected a mapping"},
        {"a: 1\n", 400000, ":2: YAML: found the key 'a' again"},
        {"hello\n", 6, ":1: scene: found 'hello', expected a mapping"},
    };
    temporary_path(&folder, path, "junk.yaml");
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        size_t period = strlen(cases[i].fill);
        for (size_t k = 0; k < cases[i].size; k++)
            junk[k] = cases[i].fill[k % period];
        put_file(path, junk, cases[i].size);
        check_fails(rl_scene_load(&scene, path, &error), &error, RL_ERR_INPUT, cases[i].message);
    }
    /* More keys than any mapping of a scene has, all different. */
    size_t length = 0;
    for (int i = 0; i < 100000; i++)
        length += (size_t)snprintf(junk + length, 32, "key%d: 1\n", i);
    put_file(path, junk, length);
    check_fails(rl_scene_load(&scene, path, &error), &error, RL_ERR_INPUT,
                ":65: YAML: found a mapping of more than 64 keys");
    free(junk);
}

/* Cut anywhere, the scene is an error or a scene, and nothing leaks. */
static void test_every_cut(void **state)
{
    (void)state;
    char path[PATH_MAX], *text;
    size_t size;
    temporary_path(&folder, path, "cut.yaml");
    write_scene(path, 0, -1, NULL);
    check_ok(rl_file_read(&text, &size, path, &error), &error);
    for (size_t n = 0; n < size; n += 3) {
        put_file(path, text, n);
        struct rl_scene scene;
        if (rl_scene_load(&scene, path, &error) == RL_OK)
            rl_scene_clear(&scene);
        else
            assert_non_null(strstr(error.message, "cut.yaml:"));
    }
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_structure), cmocka_unit_test(test_numbers), cmocka_unit_test(test_camera),
        cmocka_unit_test(test_materials), cmocka_unit_test(test_objects), cmocka_unit_test(test_lights),
        cmocka_unit_test(test_meshes),    cmocka_unit_test(test_files),   cmocka_unit_test(test_every_cut),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
