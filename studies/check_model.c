/* The check's cases of the model: its functions at points where one of their terms or branches matters. Tolerances follow from what the
 * functions promise, in units in the last place: two programs, each within n of the truth, are within 2 n of each other. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "measure/metrics.h"
#include "methods/method.h"
#include "model/attenuation.h"
#include "model/frame.h"
#include "studies/check_parts.h"

enum { ELLIPSOID_ULP = 16, ATTENUATION_ULP = 4, FRAME_ULP = 32, METRICS_ULP = 64 };

static void add_value(struct rl_check_rows *rows, const char *metric, double value, int ulp, const char *from)
{
    rl_check_fixed(rows, metric, RL_BEST_SAME, value, ulp * DBL_EPSILON * fabs(value), from, false);
}

/* At delta = 0, at the half width k sin(delta) = 1, in the tail, and near the end. */
static void ellipsoid(struct rl_check_rows *rows, const char *function, double rr)
{
    static const char *const from = "16 ulp: each program within 8 (model/ellipsoid.h)";
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    const double delta[] = {0.0, -asin(1.0 / (1.0 + rr)), 0.7, -1.5}, u[] = {0.03125, 0.25, 0.625, 0.9375};
    for (int i = 0; i < 4; i++) {
        char metric[32];
        if (strcmp(function, "inverse") == 0) {
            snprintf(metric, sizeof metric, "delta_at_%g", u[i]);
            add_value(rows, metric, rl_ellipsoid_inverse(&e, u[i]).delta, ELLIPSOID_ULP, from);
        } else {
            snprintf(metric, sizeof metric, "%s_at_%.3g", function, delta[i]);
            double value = strcmp(function, "pdf") == 0 ? rl_ellipsoid_pdf(&e, delta[i])
                                                        : rl_ellipsoid_cdf(&e, delta[i]);
            add_value(rows, metric, value, ELLIPSOID_ULP, from);
        }
    }
}

static void attenuation(struct rl_check_rows *rows)
{
    static const struct {
        const char *metric;
        double n_h, n_v, n_l, v_h;
    } point[] = {
        {"masked", 0.95, 0.2, 0.9, 0.8},        {"shadowed", 0.9, 0.85, 0.15, 0.7},
        {"both", 0.55, 0.3, 0.25, 0.6},         {"full", 0.99, 0.9, 0.95, 0.97},
        {"below_horizon", 0.8, 0.5, -0.1, 0.4},
    };
    for (size_t i = 0; i < sizeof point / sizeof point[0]; i++)
        add_value(rows, point[i].metric,
                  rl_attenuation(point[i].n_h, point[i].n_v, point[i].n_l, point[i].v_h), ATTENUATION_ULP,
                  "4 ulp: two roundings each (model/attenuation.h)");
}

/* H at one (delta, theta) about two normals, one of them below the xy-plane, where the sign in the frame changes. */
static void frame(struct rl_check_rows *rows, enum rl_frame_kind kind)
{
    static const rl_vec3 normal[] = {{0.6, 0.64, 0.48}, {0.6, -0.48, -0.64}};
    for (int i = 0; i < 2; i++) {
        struct rl_frame f = rl_frame_make(kind, normal[i]);
        rl_vec3 H = rl_frame_microfacet_normal(&f, sin(0.4), cos(0.4), 1.0);
        const double component[] = {H.x, H.y, H.z};
        for (int c = 0; c < 3; c++) {
            char metric[32];
            snprintf(metric, sizeof metric, "%s_%c", i ? "lower" : "upper", "xyz"[c]);
            rl_check_fixed(rows, metric, RL_BEST_SAME, component[c], FRAME_ULP * DBL_EPSILON,
                           "32 ulp of 1: some 15 roundings each", false);
        }
    }
}

/* Weighted sums over the pattern: a ring more or less, turned, or at another delta moves one of them. */
static void pattern(struct rl_check_rows *rows, double rr, int n)
{
    struct rl_microfacet h[RL_SAMPLES_MAX];
    struct rl_ellipsoid e = rl_ellipsoid_make(rr);
    double x = 0.0, y = 0.0, z = 0.0;
    rl_method_find("regular")->pattern(&e, n, h);
    for (int i = 0; i < n; i++) {
        x += h[i].weight * h[i].x;
        y += h[i].weight * fabs(h[i].y);
        z += h[i].weight * fabs(h[i].z);
    }
    static const char *const from = "64 + 2 n ulp of 1: weights within 32, n roundings of the sum";
    double tolerance = (64 + 2 * n) * DBL_EPSILON;
    rl_check_fixed(rows, "mean_x", RL_BEST_SAME, x, tolerance, from, false);
    rl_check_fixed(rows, "mean_abs_y", RL_BEST_SAME, y, tolerance, from, false);
    rl_check_fixed(rows, "mean_abs_z", RL_BEST_SAME, z, tolerance, from, false);
}

/* Two pixels and three colours, e = 0.5, -0.25, 0, 0.125, 0, -0.5 against references of 0 to 1: if the metrics themselves are wrong, the
 * pictures may well look better. */
static int metrics(struct rl_check_rows *rows)
{
    static const float truth[] = {0.0f, 0.5f, 1.0f, 1.0f, 0.25f, 0.75f, 0.5f, 1.0f};
    static const float error[] = {0.5f, -0.25f, 0.0f, 0.0f, 0.125f, 0.0f, -0.5f, 0.0f};
    struct rl_image image = {0}, reference = {0};
    struct rl_metrics m = {0};
    int status = rl_image_allocate(&image, 2, 1, 4, rows->error);
    if (status == RL_OK)
        status = rl_image_allocate(&reference, 2, 1, 4, rows->error);
    for (int i = 0; i < 8 && status == RL_OK; i++) {
        reference.data[i] = truth[i];
        image.data[i] = truth[i] + error[i];
    }
    if (status == RL_OK)
        status = rl_metrics_compute(&m, &image, &reference, rows->error);
    rl_image_clear(&image);
    rl_image_clear(&reference);
    const struct {
        const char *metric;
        double value;
    } figure[] = {{"rmse", m.rmse}, {"mae", m.mae},       {"max", m.max},
                  {"bias", m.bias}, {"relmse", m.relmse}, {"psnr", m.psnr}};
    for (size_t i = 0; i < sizeof figure / sizeof figure[0] && status == RL_OK; i++)
        add_value(rows, figure[i].metric, figure[i].value, METRICS_ULP,
                  "64 ulp: six terms, of single precision, exact but for relmse and psnr");
    return status;
}

int rl_check_model(struct rl_check_rows *rows, const struct rl_check_case *c,
                   struct rl_check_context *context)
{
    (void)context;
    char function[RL_NAME_MAX] = "";
    double rr = rl_parameter_number(c->parameters, "rr");
    rl_parameter(c->parameters, "function", function, sizeof function);
    if (strcmp(function, "metrics") == 0)
        return metrics(rows);
    if (strcmp(function, "attenuation") == 0)
        attenuation(rows);
    else if (strcmp(function, "frame") == 0)
        frame(rows,
              rl_parameters_match(c->parameters, "frame=printed") ? RL_FRAME_PRINTED : RL_FRAME_ORTHONORMAL);
    else if (strcmp(function, "pattern") == 0)
        pattern(rows, rr, (int)rl_parameter_number(c->parameters, "samples"));
    else
        ellipsoid(rows, function, rr);
    return rows->status;
}
