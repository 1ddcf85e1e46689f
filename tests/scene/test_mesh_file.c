/* Meshes through assimp: joined, placed by their nodes, with normals; and files that are none, which
 * neither end nor stop us. */
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/clock.h"
#include "base/files.h"
#include "base/hash.h"
#include "scene/mesh.h"
#include "support/check.h"
#include "support/temporary.h"

#ifndef __has_feature
#define __has_feature(name) 0
#endif

#define MODELS "/usr/share/assimp/models"

static struct temporary folder;
static struct rl_error error;
static char path[PATH_MAX];

static int set_up(void **state)
{
    (void)state;
    temporary_make(&folder);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    temporary_remove(&folder);
    return 0;
}

static void write_bytes(const char *name, const void *data, size_t size)
{
    temporary_path(&folder, path, name);
    check_ok(rl_file_write(path, data, size, &error), &error);
}

static int load_text(struct rl_mesh *mesh, const char *name, const char *text)
{
    write_bytes(name, text, strlen(text));
    return rl_mesh_load(mesh, NULL, path, &error);
}

/* Whatever a file holds, a mesh that was loaded can be used. */
static void check_sound(const struct rl_mesh *mesh)
{
    assert_true(mesh->n_vertices > 0);
    assert_true(mesh->n_triangles > 0);
    for (size_t i = 0; i < mesh->n_vertices; i++) {
        const float *p = mesh->position[i], *n = mesh->normal[i];
        assert_true(isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]));
        check_near(v3_length(v3(n[0], n[1], n[2])), 1.0, 1e-3);
    }
    for (size_t t = 0; t < mesh->n_triangles; t++)
        for (int i = 0; i < 3; i++)
            assert_true(mesh->triangle[t][i] < mesh->n_vertices);
}

/* A roof of two faces that meet at a right angle along z: the ridge's vertices lie between, whatever
 * splits assimp might like. */
static void test_smooth_normals(void **state)
{
    (void)state;
    struct rl_mesh mesh;
    check_ok(load_text(&mesh, "roof.obj",
                       "v 0 1 0\nv 0 1 1\nv -1 0 1\nv -1 0 0\nv 1 0 1\nv 1 0 0\nf 1 4 3 2\nf 1 2 5 6\n"),
             &error);
    check_sound(&mesh);
    assert_int_equal(mesh.n_vertices, 6);
    assert_int_equal(mesh.n_triangles, 4);
    for (size_t i = 0; i < mesh.n_vertices; i++) {
        const float *p = mesh.position[i], *n = mesh.normal[i];
        double lean = p[1] > 0.5 ? 0.0 : p[0] > 0.0 ? sqrt(0.5) : -sqrt(0.5);
        check_near(fabs((double)n[0]), fabs(lean), p[1] > 0.5 ? 0.35 : 1e-6);
        assert_true(n[1] > 0.0f);
    }
    rl_mesh_clear(&mesh);
}

static void test_given_normals(void **state)
{
    (void)state;
    struct rl_mesh mesh;
    check_ok(load_text(&mesh, "given.obj",
                       "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nvn 0 0 0\nf 1//1 2//1 3//2\n"),
             &error);
    check_sound(&mesh);
    for (size_t i = 0; i < mesh.n_vertices; i++)
        if (mesh.position[i][1] < 0.5f)
            check_near((double)mesh.normal[i][0], 0.6, 1e-6); /* as given */
        else
            check_near((double)mesh.normal[i][2], 1.0, 1e-6); /* a zero normal is made good */
    rl_mesh_clear(&mesh);
}

/* One triangle in a glTF file under two nodes, one of which mirrors: its triangle must still face the way
 * of its normal. */
static void test_node_transforms(void **state)
{
    (void)state;
    static const float bin[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.6f, 0.8f, 0, 0.6f, 0.8f, 0, 0.6f, 0.8f};
    write_bytes("triangle.bin", bin, sizeof bin);
    struct rl_mesh mesh;
    uint64_t hash = RL_HASH_START, other = RL_HASH_START;
    check_ok(
        load_text(&mesh, "nodes.gltf",
                  "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],"
                  "\"nodes\":[{\"mesh\":0,\"translation\":[10,0,0]},{\"mesh\":0,\"scale\":[-2,1,1]}],"
                  "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}]}],"
                  "\"buffers\":[{\"uri\":\"triangle.bin\",\"byteLength\":72}],"
                  "\"bufferViews\":[{\"buffer\":0,\"byteLength\":72}],"
                  "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
                  "\"min\":[0,0,0],\"max\":[1,1,0]},{\"bufferView\":0,\"byteOffset\":36,"
                  "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}]}"),
        &error);
    check_sound(&mesh);
    assert_int_equal(mesh.n_triangles, 2);
    rl_vec3 low, high, centre;
    double radius;
    rl_mesh_bounds(&mesh, &low, &high, &centre, &radius);
    check_near(low.x, -2.0, 1e-6);
    check_near(high.x, 11.0, 1e-6);
    for (size_t t = 0; t < 2; t++) {
        rl_vec3 p[3];
        for (int i = 0; i < 3; i++) {
            const float *q = mesh.position[mesh.triangle[t][i]];
            p[i] = v3(q[0], q[1], q[2]);
        }
        rl_vec3 face = v3_cross(v3_sub(p[1], p[0]), v3_sub(p[2], p[0]));
        const float *n = mesh.normal[mesh.triangle[t][0]];
        assert_true(v3_dot(face, v3(n[0], n[1], n[2])) > 0.0);
        assert_true(face.z > 0.0);
        check_near((double)n[1], 0.6, 1e-6); /* as in the file: the stretch along x leaves it alone */
    }
    rl_mesh_clear(&mesh);

    /* The hash takes in the file that the glTF file names. */
    char gltf[PATH_MAX];
    temporary_path(&folder, gltf, "nodes.gltf");
    check_ok(rl_mesh_load(&mesh, &hash, gltf, &error), &error);
    rl_mesh_clear(&mesh);
    static const float moved[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0.5f};
    write_bytes("triangle.bin", moved, sizeof moved);
    check_ok(rl_mesh_load(&mesh, &other, gltf, &error), &error);
    rl_mesh_clear(&mesh);
    assert_true(hash != other);

    temporary_path(&folder, path, "triangle.bin");
    assert_int_equal(remove(path), 0);
    check_fails(rl_mesh_load(&mesh, NULL, gltf, &error), &error, RL_ERR_INPUT,
                "nodes.gltf: found what assimp cannot read");
}

static void test_refused(void **state)
{
    (void)state;
    static const struct {
        const char *name, *text, *words;
    } cases[] = {
        {"empty.obj", "", "empty.obj: found an empty file"},
        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "points.obj: found"},
        {"line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "line.obj: found"},
        {"nan.obj", "v nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
         "nan.obj: found vertex 0 at (nan, nan, nan), expected finite"},
        {"inf.obj", "v 1e39 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
         "inf.obj: found vertex 0 at (inf, 0, 0), expected finite"},
        {"range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "range.obj: found"},
        {"what.xyzzy", "no mesh\n", "what.xyzzy: found what assimp cannot read (No suitable reader"},
        {"cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n",
         "cut.ply: found a file cut off"},
        {"text.ply", "no mesh\n", "text.ply:1: found no PLY header"},
        {"cut.gltf", "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,",
         "cut.gltf: found what assimp cannot read"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct rl_mesh mesh;
        check_fails(load_text(&mesh, cases[i].name, cases[i].text), &error, RL_ERR_INPUT, cases[i].words);
        assert_null(mesh.position);
    }
    struct rl_mesh mesh;
    check_fails(rl_mesh_load(&mesh, NULL, folder.folder, &error), &error, RL_ERR_INPUT, "not a regular file");
}

/* Files of assimp's own collection. */
static void test_models(void **state)
{
    (void)state;
    static const struct {
        const char *file;
        size_t triangles;
    } cases[] = {
        {"PLY/Wuson.ply", 3732},
        {"PLY/cube.ply", 12},
        {"PLY/cube_binary.ply", 12},
        {"OBJ/WusonOBJ.obj", 3732},
        {"OBJ/box.obj", 12},
        {"OBJ/concave_polygon.obj", 64},
        {"OFF/Wuson.off", 3732},
        {"STL/Spider_binary.stl", 1368},
        {"Collada/duck.dae", 4212},
        {"glTF2/BoxTextured-glTF/BoxTextured.gltf", 12},
        {"glTF/TwoBoxes/TwoBoxes.gltf", 24},
        {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", 12},
    };
    if (access(MODELS, R_OK) != 0) {
        print_message("no %s here (Debian: assimp-testmodels)\n", MODELS);
        skip();
    }
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct rl_mesh mesh;
        snprintf(path, sizeof path, MODELS "/%s", cases[i].file);
        check_ok(rl_mesh_load(&mesh, NULL, path, &error), &error);
        check_sound(&mesh);
        assert_int_equal(mesh.n_triangles, cases[i].triangles);
        rl_mesh_clear(&mesh);
    }
}

/* Each of assimp's files that are none: an error or a sound mesh, soon. OutOfMemory.off is left to the
 * memory limit, which sanitizers do not allow; they let it run into the time limit. */
static void test_invalid_models(void **state)
{
    (void)state;
    static const char *const files[] = {
        "invalid/empty.3ds",
        "invalid/empty.ase",
        "invalid/empty.lwo",
        "invalid/empty.md5mesh",
        "invalid/empty.obj",
        "invalid/empty.off",
        "invalid/empty.ply",
        "invalid/empty.raw",
        "invalid/empty.smd",
        "invalid/empty.x",
        "invalid/malformed.obj",
        "invalid/malformed2.obj",
        "invalid/emptyIrrMesh.xml",
        "invalid/readme.txt",
        "OFF/invalid.off",
        "PLY/points.ply",
        "PLY/issue623.ply",
        "glTF2/MissingBin/BoxTextured.gltf",
        "glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb",
        "glTF2/RecursiveNodes/RecursiveNodes.gltf",
#if !defined __SANITIZE_ADDRESS__ && !__has_feature(address_sanitizer) /* gcc, clang */
        "invalid/OutOfMemory.off",
#endif
    };
    if (access(MODELS "/invalid", R_OK) != 0) {
        print_message("no %s here (Debian: assimp-testmodels)\n", MODELS "/invalid");
        skip();
    }
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        struct rl_mesh mesh;
        snprintf(path, sizeof path, MODELS "/%s", files[i]);
        double start = rl_clock_seconds();
        int status = rl_mesh_load(&mesh, NULL, path, &error);
        assert_true(rl_clock_seconds() - start < 8.0);
        if (status == RL_OK) {
            check_sound(&mesh);
        } else {
            assert_int_equal(status, RL_ERR_INPUT);
            assert_non_null(strstr(error.message, path));
            assert_null(strpbrk(error.message, "\r\n"));
        }
        rl_mesh_clear(&mesh);
    }
}

/* Cut binary files, at some places: an error or a sound mesh, never a crash. */
static void test_cut_models(void **state)
{
    (void)state;
    static const char *const files[] = {"glTF2/BoxTextured-glTF-Binary/BoxTextured.glb",
                                        "STL/Spider_binary.stl", "OBJ/box.obj", "PLY/cube_binary.ply"};
    if (access(MODELS, R_OK) != 0) {
        print_message("no %s here (Debian: assimp-testmodels)\n", MODELS);
        skip();
    }
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++)
        for (int tenth = 1; tenth < 10; tenth += 2) {
            char *data, name[32];
            size_t size;
            snprintf(path, sizeof path, MODELS "/%s", files[i]);
            check_ok(rl_file_read(&data, &size, path, &error), &error);
            snprintf(name, sizeof name, "cut%s", strrchr(files[i], '.'));
            write_bytes(name, data, size * (size_t)tenth / 10);
            free(data);
            struct rl_mesh mesh;
            int status = rl_mesh_load(&mesh, NULL, path, &error);
            if (status == RL_OK)
                check_sound(&mesh);
            else
                assert_int_equal(status, RL_ERR_INPUT);
            assert_true(status != RL_OK || !strstr(name, "ply"));
            rl_mesh_clear(&mesh);
        }
}

/* assimp says nothing on our stdout or stderr, whatever it thinks of a file. */
static void test_silence(void **state)
{
    (void)state;
    char talk[PATH_MAX];
    temporary_path(&folder, talk, "talk.txt");
    fflush(NULL);
    int out = dup(STDOUT_FILENO), err = dup(STDERR_FILENO);
    int file = open(talk, O_CREAT | O_WRONLY | O_TRUNC, 0666);
    assert_true(out >= 0 && err >= 0 && file >= 0);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    struct rl_mesh mesh;
    int status = load_text(&mesh, "bad.obj", "v 0 0 0\nf 1 2 3\nf a b c\nusemtl none\nmtllib none.mtl\n");
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    close(out);
    close(err);
    close(file);
    rl_mesh_clear(&mesh);
    assert_int_equal(status, RL_ERR_INPUT);
    char *data;
    size_t size;
    check_ok(rl_file_read(&data, &size, talk, &error), &error);
    free(data);
    assert_int_equal(size, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_smooth_normals),  cmocka_unit_test(test_given_normals),
        cmocka_unit_test(test_node_transforms), cmocka_unit_test(test_refused),
        cmocka_unit_test(test_models),          cmocka_unit_test(test_invalid_models),
        cmocka_unit_test(test_cut_models),      cmocka_unit_test(test_silence),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
