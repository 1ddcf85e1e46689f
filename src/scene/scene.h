/* A scene as loaded: camera, film, objects in world space, materials and lights.
 *
 *     struct rl_scene scene;
 *     if (rl_scene_load(&scene, "studies/scenes/teapot-star.yaml", &error) == RL_OK) {
 *         ...
 *         rl_scene_clear(&scene);
 *     }
 *
 * Lengths are in one unit of the scene's choice, angles in files in degrees, radiance in W/(m^2 sr) or any
 * other unit, linear RGB; intensity is radiance times area, irradiance is radiance times solid angle. Photometric scenes are in metres, and
 * radiance is luminance in cd/m^2 divided by `white`. World axes are right-handed. studies/scenes/README.md describes the format.
 */
#ifndef RL_SCENE_SCENE_H
#define RL_SCENE_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "effects/effect.h"
#include "model/material.h"
#include "model/vec3.h"
#include "scene/mesh.h"
#include "scene/settings.h"

enum { RL_POLYGON_VERTICES_MAX = 64 };

/* Coordinates and lengths of a scene lie within +-RL_LENGTH_MAX, so that single precision and its squares
 * hold them. */
#define RL_LENGTH_MAX 1e9

/* A planar, simple polygon of 3 to 64 vertices, convex or not; shines from both sides. */
struct rl_polygon {
    int n;
    rl_vec3 *vertex;
    rl_vec3 normal; /* unit; counter-clockwise seen from its tip */
    double area;
    uint32_t (*triangle)[3]; /* n - 2 triangles that tile it (ear clipping), as indices into `vertex` */
};

struct rl_light {
    char *name;
    size_t n_polygons; /* 1 for a polygon light; the triangles of a mesh light */
    struct rl_polygon *polygon;
    double radiance[3]; /* RGB, >= 0 */
    rl_vec3 centroid;   /* by area */
    rl_vec3 centre;     /* of the bounding sphere */
    double radius;      /* of the bounding sphere */
    /* Of a flat one: of one side. Else what it shows on average over all directions (Cauchy): a quarter of a closed mesh's surface, half of
     * an open one's. */
    double area;
    bool mesh, closed; /* of a polygon, too: false */
    rl_vec3 normal;    /* of a flat mesh, unit; else 0 */
};

/* A light without shape is a struct rl_source (effects/effect.h). */

struct rl_object {
    char *name;
    struct rl_mesh mesh; /* world space */
    int material;        /* index */
    rl_vec3 centre;      /* of the mesh's box: where its environment map is taken */
    double radius;       /* about the centre */
};

struct rl_camera {
    rl_vec3 position;
    rl_vec3 right, up, forward; /* orthonormal, right-handed with -forward as z */
    double fov_y;               /* vertical, radians */
    /* Distances along `forward`, 0 < near_plane < far_plane: what is nearer or farther is not seen. They enclose every object in the view
     * but where the scene file says otherwise, or where the near one would be below a thousandth of the far one. */
    double near_plane, far_plane;
    bool near_given, far_given; /* by the scene file */
};

struct rl_scene {
    char *path;
    uint64_t hash;     /* of the file's bytes and of every mesh file it names */
    int width, height; /* film, pixels */
    struct rl_camera camera;
    size_t n_materials, n_objects, n_lights, n_sources;
    struct rl_material *material;
    struct rl_object *object;
    struct rl_light *light;   /* those with a shape */
    struct rl_source *source; /* point and parallel lights */
    /* cd/m^2 that 1 stands for in a photometric scene: radiance is luminance over white, intensity luminous intensity over white, and so on,
     * and so are the pictures. 0: a radiometric scene. */
    double white;
    struct rl_settings settings; /* RL_SETTINGS_DEFAULT with what the file's `render` block says */
};

/* RL_ERR_INPUT: one line "FILE:LINE: KEY: found ..., expected ...", or "FILE: ..." where the file cannot
 * be read; the scene is empty then. RL_ERR_CANCELLED: interrupted while a mesh was read. */
int rl_scene_load(struct rl_scene *scene, const char *path, struct rl_error *error);
void rl_scene_clear(struct rl_scene *scene);

/* Fills a polygon from n vertices: checks 3 <= n <= 64, finite, planar to 1e-6 of its size, simple, area >
 * 0; triangulates it. */
int rl_polygon_make(struct rl_polygon *polygon, const rl_vec3 *vertex, int n, struct rl_error *error);
void rl_polygon_clear(struct rl_polygon *polygon);

/* Whether the triangles of a mesh light enclose something: each edge belongs to two of them, or four, and so on. Vertices within a millionth
 * of the light's radius are one. */
int rl_light_closed(bool *closed, const struct rl_light *light, struct rl_error *error);

/* The light as effects without shape see it. */
struct rl_point_light rl_light_as_point(const struct rl_light *light);

/* The scene's lights as effects see them, in its order. Clear what was made, also after an error. */
int rl_scene_lights_make(struct rl_lights *lights, const struct rl_scene *scene, struct rl_error *error);
void rl_scene_lights_clear(struct rl_lights *lights);

/* World direction (unit) through the centre of pixel (x, y) of a width x height image; y = 0 is the top
 * row. */
rl_vec3 rl_camera_ray(const struct rl_camera *camera, int width, int height, int x, int y);

/* Room for rounding in single precision, in units of the lengths compared. */
#define RL_VIEW_SLACK 1e-5
/* Whether no pixel of such a film can show anything of a sphere, whatever the planes: it is behind the eye or beside the view. */
bool rl_camera_misses(const struct rl_camera *camera, int width, int height, rl_vec3 centre, double radius);

/* For a film of another shape than the scene's, which shows other objects: fits the planes that the file does not give again. */
void rl_scene_fit_planes(struct rl_scene *scene, int width, int height);

/* Column-major 4x4 for OpenGL: clip = projection x view x world. Depth is -1 at the near plane and 1 at the far one; `reversed`: 1 and
 * 0, for a clip volume from zero to one. */
void rl_camera_matrix(const struct rl_camera *camera, int width, int height, bool reversed,
                      double matrix[16]);

#endif
