/* Which triangle each pixel shows, in double precision and without a tree: what depth buffers of few bits are held against, and what an
 * ideal one of so many bits would show.
 *
 * Every triangle is met with the rays of all pixels that it may cover, in homogeneous coordinates: with the corners v_i relative to the eye
 * and d the ray, scaled to 1 along the view direction, d = sum a_i v_i. The ray meets the triangle where all a_i >= 0, and 1/z = sum a_i,
 * both linear over the picture; no corner need lie before the eye (Olano and Greer 1997, "Triangle scan conversion using 2D homogeneous
 * coordinates").
 *
 *     struct rl_raster_options options = {.width = 320, .height = 240, .culling = true};
 *     rl_raster_draw(pixel, &scene, &options);
 */
#ifndef RL_REFERENCE_RASTER_H
#define RL_REFERENCE_RASTER_H

#include <stdbool.h>
#include <stdint.h>

#include "scene/scene.h"

struct rl_raster_options {
    int width, height;
    double dx, dy;  /* the ray's place off the pixel's centre, in pixels right and down */
    bool culling;   /* as the settings of these names */
    int depth_bits; /* 0: exact depth; 16 or 24: rounded to the nearest of 2^b whole steps; 32: to float */
    bool reversed_depth;
};

struct rl_raster_pixel {
    uint32_t object, triangle; /* from 1 on; 0: background */
    double z;                  /* of the surface shown, along the view direction */
    double gap; /* exact depth: to the next surface behind it, in z; infinite if there is none */
};

/* Fills width x height pixels, row 0 the top one. Of equal depths the first drawn stays, as with GL_LESS; so does what the depth buffer was
 * cleared to, so that a surface which rounds to the far plane's depth is not seen. */
void rl_raster_draw(struct rl_raster_pixel *pixel, const struct rl_scene *scene,
                    const struct rl_raster_options *options);

/* z where the ray through the pixel's centre meets the plane of a triangle (numbers from 1 on). */
double rl_raster_depth(const struct rl_scene *scene, const struct rl_raster_options *options, uint32_t object,
                       uint32_t triangle, int x, int y);

/* How far apart in z two surfaces at z are, one step of an ideal depth buffer: z^2 (far - near)/(far near) times the step of depth,
 * which is 2^-b of whole numbers (near enough: z^2/(near 2^b)), and of floats what their exponent makes it. */
double rl_raster_resolution(const struct rl_camera *camera, const struct rl_raster_options *options,
                            double z);

#endif
