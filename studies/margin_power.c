/* Lights made for `margin auto` to lose as much as they can beside its sphere (see margin.h): a scene's own lights may lose so little
 * that a margin far too small would go unnoticed. */
#include <math.h>
#include <string.h>

#include "model/ellipsoid.h"
#include "scene/margin.h"
#include "studies/margin.h"

/* The share of the lobe about R = N that meets a cap of angular radius a, its middle at the angle `beside` from R. L is at 2 delta from
 * N along the line theta, and L.u = M cos(2 delta - psi); where that is cos a or more, the weight is a difference of the cdf. */
static double weight(const struct rl_ellipsoid *e, double beside, double a)
{
    enum { LINES = 400 };
    double sum = 0.0;
    for (int i = 0; i < LINES; i++) {
        double across = sin(beside) * cos(RL_PI * ((i + 0.5) / LINES - 0.5)), along = cos(beside);
        double M = hypot(along, across);
        if (cos(a) > M)
            continue;
        double psi = atan2(across, along), half = acos(cos(a) / M);
        double from = 0.5 * (psi - half), to = fmin(0.5 * (psi + half), 0.25 * RL_PI); /* L.N > 0 */
        if (to > from)
            sum += rl_ellipsoid_cdf(e, to) - rl_ellipsoid_cdf(e, from);
    }
    return sum / LINES;
}

/* The angle b that the proof asks for beside a light (margin.h, both sides): 1 - U(b/2) = loss/2, from D's integral and not by
 * the functions that the closed form calls. NaN where no angle is large enough. */
static double asked_angle(double rr, double loss)
{
    double k = sqrt(fabs(rr * rr - 1.0)), share = 1.0 - loss;
    double sine = rr > 1.0 ? tan(share * atan(k)) / k : rr < 1.0 ? tanh(share * atanh(k)) / k : share;
    return 2.0 * asin(sine);
}

struct rl_margin_filled rl_margin_filled(double rr, double loss)
{
    enum { SIZES = 104 }; /* up to almost a half space */
    static const double distance = 10.0;
    struct rl_object object = {.radius = 1.0};
    struct rl_light light[2] = {{.centre = {0.0, distance, 0.0}}, {.centre = {0.0, -distance, 0.0}}};
    struct rl_scene scene = {.n_objects = 1, .object = &object, .n_lights = 2, .light = light};
    struct rl_plan_material material = {.rr = rr, .method = rl_method_find("random")};
    struct rl_settings settings = RL_SETTINGS_DEFAULT;
    settings.normal_bits =
        RL_NORMAL_BITS_FLOAT; /* no room for rounding and texels, of which there are none here */
    settings.env_size = 1 << 24;
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    double asked = asked_angle(rr, loss);
    struct rl_margin_filled most = {NAN, NAN};
    for (int i = 0; i < SIZES; i++) {
        double a = 0.01 * pow(1.05, i);
        light[0].radius = light[1].radius = distance * sin(a);
        double sphere = (1.0 + rl_margin_auto(&scene, &material, &settings, loss)) * sin(a);
        if (sphere < 1.0)
            most.lost = fmax(most.lost, 2.0 * weight(&e, asin(sphere), a) / loss);
        if (a + asked < 0.5 * RL_PI)
            most.due = fmax(most.due, 2.0 * weight(&e, a + asked, a) / loss);
    }
    return most;
}
