/* Look-ups in a cube map near its seams: for directions on edges and corners of the cube, and just off them, the GPU finds the texel that
 * OpenGL's table has there, by the program's own texture and the shaders' own function. Nothing is blended, and nothing lost between. */
#include "gpu/compute.h"
#include "gpu/context.h"
#include "gpu/fixture.h"
#include "gpu/textures.h"

enum { SIZE = 8 };

static struct rl_gpu *gpu;

static int open_gpu(void **state)
{
    (void)state;
    struct rl_error error;
    return rl_gpu_open(&gpu, "auto", &error);
}

static int close_gpu(void **state)
{
    (void)state;
    rl_gpu_close(gpu);
    return 0;
}

/* Texel (x, y) of a face holds the face, x and y. */
static GLuint numbered_cube(void)
{
    struct rl_gl *gl = &gpu->gl;
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    struct rl_error error;
    GLuint cube = 0;
    settings.env_size = SIZE;
    settings.env_format = RL_TEXEL_RGBA32F;
    check_ok(rl_cube_make(&cube, gl, &settings, &error), &error);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int face = 0; face < 6; face++) {
        float texel[SIZE * SIZE][4];
        for (int i = 0; i < SIZE * SIZE; i++) {
            int x = i % SIZE, y = i / SIZE;
            const float numbers[] = {(float)face, (float)x, (float)y, 1.0f};
            memcpy(texel[i], numbers, sizeof numbers);
        }
        gl->TexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + (GLenum)face, 0, 0, 0, SIZE, SIZE, GL_RGBA,
                          GL_FLOAT, texel);
    }
    check_ok(rl_gl_check(gl, "a cube map of numbers", &error), &error);
    return cube;
}

/* OpenGL 4.5 core, table 8.19: the components along a face's s, t and outward axes. */
static void on_face(double out[3], int face, const float d[3])
{
    static const struct {
        int s, t, outward;
        double s_sign, t_sign, sign;
    } axes[6] = {{2, 1, 0, -1, -1, 1}, {2, 1, 0, 1, -1, -1}, {0, 2, 1, 1, 1, 1},
                 {0, 2, 1, 1, -1, -1}, {0, 1, 2, 1, -1, 1},  {0, 1, 2, -1, -1, -1}};
    out[0] = axes[face].s_sign * d[axes[face].s];
    out[1] = axes[face].t_sign * d[axes[face].t];
    out[2] = axes[face].sign * d[axes[face].outward];
}

/* Whether a texel may be the one that has x = (s/w + 1) SIZE/2 in it, clamped to the face: to some units in the last place of a float. */
static bool may_be(double texel, double s, double w)
{
    double x = 0.5 * (s / w + 1.0) * SIZE, room = 4.0 * 0x1p-23 * SIZE;
    return texel >= fmin(floor(x - room), SIZE - 1) && texel <= fmax(floor(x + room), 0.0) && texel >= 0.0 &&
           texel < SIZE;
}

/* The face must be one along which the direction is largest; `room`: relative, for functions that round. */
static bool right(const float found[3], const float d[3], double room)
{
    double v[3], most = fmax(fabs((double)d[0]), fmax(fabs((double)d[1]), fabs((double)d[2])));
    int face = (int)found[0];
    if (found[0] != (float)face || face < 0 || face > 5)
        return false;
    on_face(v, face, d);
    return v[2] >= most * (1.0 - room) && may_be(found[1], v[0], v[2]) && may_be(found[2], v[1], v[2]);
}

enum { ROWS_MAX = 20000 };
static float directions[ROWS_MAX][3], results[ROWS_MAX][6];

/* Two components of largest magnitude, one of them off by so much, the third anywhere, in corners too; of any length. */
static size_t make_directions(void)
{
    static const double off[] = {0.0,    0x1p-23, -0x1p-24, 0x1p-22, -0x1p-23, 1e-12,
                                 -1e-12, 1e-6,    -1e-6,    1e-3,    -1e-3},
                        third[] = {0.0, -0.0, 0.1, -0.5, 0.999, 1.0, -1.0, 0x1.fffffep-1, 1.0 - 1e-6},
                        length[] = {1.0, 1e-12, 1e12};
    size_t n = 0;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = 0; sign < 4; sign++)
            for (size_t i = 0; i < sizeof off / sizeof off[0]; i++)
                for (size_t t = 0; t < sizeof third / sizeof third[0]; t++)
                    for (size_t l = 0; l < sizeof length / sizeof length[0]; l++) {
                        float *d = directions[n++];
                        assert_true(n <= ROWS_MAX);
                        d[axis] = (float)(length[l] * (sign & 1 ? -1.0 : 1.0));
                        d[(axis + 1) % 3] = (float)(length[l] * (sign & 2 ? -1.0 : 1.0) * (1.0 + off[i]));
                        d[(axis + 2) % 3] = (float)(length[l] * third[t]);
                    }
    return n;
}

static void look_ups_find_the_texel(void **state)
{
    (void)state;
    static const char *const modules[] = {"common/surface", "common/attenuation_off", "common/environment",
                                          "passes/probe"};
    /* With H along V the light comes from there, by the function that methods call. */
    static const char glue[] =
        "void evaluate(float a[N_IN], out float r[N_OUT])\n"
        "{\n"
        "    vec3 d = vec3(a[0], a[1], a[2]);\n"
        "    vec3 plain = texture(environment_map, d).rgb;\n"
        "    vec3 V = normalize(d);\n"
        "    vec3 by_method = microfacet_radiance(Surface(vec3(0.0), V, V), 1.0, V, 1.0);\n"
        "    r = float[N_OUT](plain.x, plain.y, plain.z, by_method.x, by_method.y, by_method.z);\n"
        "}\n";
    struct rl_error error;
    struct rl_plan_program program = {.pass = "probe"};
    struct rl_gl *gl = &gpu->gl;
    size_t n = make_directions(), wrong = 0, by_method = 0, faces[6] = {0};
    for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++)
        snprintf(program.module[program.n_modules++], RL_PLAN_MODULE_NAME, "%s", modules[i]);
    GLuint cube = numbered_cube();
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_CUBE_MAP, cube);
    check_ok(rl_gpu_compute(gpu, &program, glue, directions[0], 3, results[0], 6, n, &error), &error);
    gl->BindTexture(GL_TEXTURE_CUBE_MAP, 0);
    gl->DeleteTextures(1, &cube);
    for (size_t i = 0; i < n; i++) {
        const float *d = directions[i], *r = results[i];
        if (!right(r, d, 0.0) && wrong++ < 5)
            print_message("%.9g %.9g %.9g: face %g, texel %g, %g\n", d[0], d[1], d[2], r[0], r[1], r[2]);
        by_method += !right(r + 3, d, 8.0 * 0x1p-23);
        for (int face = 0; face < 6; face++)
            faces[face] += r[0] == (float)face;
    }
    print_message("%zu directions, %zu wrong, %zu by the method's function\n", n, wrong, by_method);
    assert_int_equal(wrong, 0);
    assert_int_equal(by_method, 0);
    for (int face = 0; face < 6; face++)
        assert_true(faces[face] > n / 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(look_ups_find_the_texel),
    };
    return cmocka_run_group_tests(tests, open_gpu, close_gpu);
}
