/* Photometry: how luminance follows from what lamps are sold by.
 *
 * A surface of constant radiance L (Lambertian) of area dA sends the flux d2 Phi = L cos(t) dA do into the solid angle do at the angle t
 * from its normal. So a flat one of area A has
 *
 *     intensity along its normal      I   = L A                                  (at the angle t: I cos t)
 *     exitance of one side            M   = integral of L cos(t) do = pi L       over the hemisphere, do = 2 pi sin(t) dt
 *     flux of one side                Phi = pi A L                               L = Phi/(pi A)
 *     flux of both                    Phi = 2 pi A L                             L = Phi/(2 pi A)
 *
 * and a closed body whose outside, of area S, has the radiance L, has Phi = pi S L (of a body that is not convex a part of it falls on the
 * body itself). A point that shines evenly all round has Phi = 4 pi I. Lambert 1760, Photometria; in today's words ISO 80000-7, and BIPM,
 * The International System of Units, 9th edition, 2019: lm = cd sr, lx = lm/m^2.
 *
 * The same equations hold of radiant quantities (W, W/sr, W/m^2, W/(m^2 sr)) and of luminous ones (lm, cd, lx, cd/m^2); lengths are metres.
 * What divides a light's strength by the functions below is its radiance or luminance.
 */
#ifndef RL_MODEL_PHOTOMETRY_H
#define RL_MODEL_PHOTOMETRY_H

#include "model/vec3.h"

/* The luminance of linear RGB with the primaries and the white of ITU-R BT.709-6 (weights: its item 3.2), in the unit of R = G = B. */
static inline double rl_luminance(const double rgb[3])
{
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/* Flux over luminance. A flat polygon of area A, by how many of its sides: 1 or 2. */
static inline double rl_flux_of_polygon(double area, int sides)
{
    return sides * RL_PI * area;
}

/* A closed body with the surface S. */
static inline double rl_flux_of_body(double surface)
{
    return RL_PI * surface;
}

/* Flux over intensity, of a point. */
static inline double rl_flux_of_point(void)
{
    return 4.0 * RL_PI;
}

#endif
