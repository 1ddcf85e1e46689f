/* Lambert's diffuse reflection of polygon lights by their exact irradiance, and of point and parallel lights as the effect `diffuse`.
 *
 * A polygon of radiance 1 with vertices v_i as seen from P, all above the horizon N.v >= 0, gives the irradiance (Lambert 1760)
 *
 *     E = | 1/2 sum over edges of  angle_i (gamma_i . N) |,   gamma_i = (v_i x v_i+1)/|v_i x v_i+1|,   angle_i between v_i and v_i+1
 *
 * and k_d E/pi comes back. The sum changes its sign with the winding: lights shine from both sides, so its size counts.
 *
 * What is below the horizon is cut off: an edge keeps its part above, and what closes the polygon along the horizon adds angles about N.
 * All crossings lie on one line, the polygon's plane cut by the horizon, so that angles from the first crossing to the others are signed,
 * less than pi, and add up in any order: those where the outline comes up count as ends, those where it goes down as beginnings. So no
 * list of vertices is made, and a polygon may be concave and cross often.
 *
 * P on an edge's line has no gamma there and the angle 0 or pi: such edges give 0. P in the polygon's plane receives nothing from a polygon
 * that it is not in; of one that it is in, it gets what is seen from one of its sides.
 *
 * Polygons of a closed mesh count half: a ray into a convex body meets two of its faces (src/scene/seen_lights.c). */
#include "effects/lambert.h"

/* The angle about N from a to b, both on the horizon. 0 where one of them is P itself: + 0.0, for atan2 makes pi of 0 and -0. */
static double turn(rl_vec3 N, rl_vec3 a, rl_vec3 b)
{
    return atan2(v3_dot(N, v3_cross(a, b)), v3_dot(a, b) + 0.0);
}

/* The signed sum over edges, twice the irradiance. */
static double edge_sum(const struct rl_surface *s, const rl_vec3 *vertex, int n)
{
    double sum = 0.0;
    bool crossed = false;
    rl_vec3 first = {0.0, 0.0, 0.0};
    rl_vec3 b = v3_sub(vertex[n - 1], s->P);
    double z_b = v3_dot(s->N, b);
    for (int i = 0; i < n; i++) {
        rl_vec3 a = b;
        double z_a = z_b;
        b = v3_sub(vertex[i], s->P);
        z_b = v3_dot(s->N, b);
        if (!(z_a > 0.0) && !(z_b > 0.0))
            continue;
        /* a x b = a x (b - a) = b x (b - a): nothing cancels where the light is far and small, nor, by the shorter one, where one end is near. */
        rl_vec3 across =
            v3_cross(v3_dot(a, a) < v3_dot(b, b) ? a : b, v3_sub(vertex[i], vertex[i > 0 ? i - 1 : n - 1]));
        double size = v3_length(across), sine = size, cosine = v3_dot(a, b);
        if (!(z_a > 0.0) || !(z_b > 0.0)) {
            /* Where the edge crosses the horizon, (|z_b| a + |z_a| b)/(|z_a| + |z_b|): both terms have one sign, and the angle's sine is
             * not one of a difference, for (|z_b| a + |z_a| b) x b = |z_b| a x b. The point and not its direction alone, whose products
             * would leave the range of numbers where the light is large or small. */
            bool up = !(z_a > 0.0);
            double part_a = fabs(z_b) / (fabs(z_a) + fabs(z_b)), part_b = fabs(z_a) / (fabs(z_a) + fabs(z_b));
            rl_vec3 crossing = v3_add(v3_scale(part_a, a), v3_scale(part_b, b));
            first = crossed ? first : crossing;
            crossed = true;
            sum += (up ? 1.0 : -1.0) * turn(s->N, first, crossing);
            sine = (up ? part_a : part_b) * size;
            cosine = v3_dot(crossing, up ? b : a);
        }
        if (size > 0.0)
            sum += atan2(sine, cosine) * (v3_dot(s->N, across) / size);
    }
    return sum;
}

static void area(const struct rl_surface *s, const rl_vec3 *vertex, int n, double params[][4], double rgb[3])
{
    double irradiance = 0.5 * fabs(edge_sum(s, vertex, n));
    for (int c = 0; c < 3; c++)
        rgb[c] = params[0][c] * irradiance;
}

const struct rl_effect rl_effect_diffuse_area = {
    .name = "diffuse-area",
    .summary = "k_d: Lambert's law, polygon lights by their exact irradiance",
    .sees = RL_SEES_SOURCES | RL_SEES_POLYGONS,
    .roles = RL_ROLE_DIFFUSE,
    .param = rl_lambert_param,
    .modules = {"common/arctangent"},
    .n_params = 1,
    .pack = rl_lambert_pack,
    .reflect = rl_lambert_reflect,
    .area = area,
    .absolute = 1e-6,
};
