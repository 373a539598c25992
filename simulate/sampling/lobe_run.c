/* lobe_run.c - the concentric map of lobe.h, by lanes. */
#include "simulate/sampling/lobe_run.h"

#include <math.h>
#include <string.h>

/* Absolute values of the lanes: the sign bit is cleared. */
#define LANES_MAGNITUDE(a) ((pp_lanes)((pp_lanes_mask)(a)&INT64_C(0x7fffffffffffffff)))

PP_LANES_BODY void sample(const struct pp_frame *frame, const double *u1,
                          const double *u2, double *to_x, double *to_y, double *to_z)
{
    pp_lanes a, b;
    memcpy(&a, u1, sizeof a);
    memcpy(&b, u2, sizeof b);
    a = 2.0 * a - 1.0;
    b = 2.0 * b - 1.0;
    pp_lanes_mask is_a = LANES_MAGNITUDE(a) > LANES_MAGNITUDE(b);
    pp_lanes r = PP_LANES_CHOOSE(is_a, a, b), other = PP_LANES_CHOOSE(is_a, b, a);
    /* If r is 0, other is 0 as well. */
    pp_lanes_mask some = r != 0.0;
    pp_lanes over = PP_LANES_CHOOSE(some, r, other + 1.0);
    pp_lanes angle = PP_PI / 4.0 * (other / over);

    /* pp_lobe_small_sincos */
    pp_lanes y = angle * angle;
    pp_lanes s = 1.0 / 6227020800.0 * y - 1.0 / 39916800.0;
    s = s * y + 1.0 / 362880.0;
    s = s * y - 1.0 / 5040.0;
    s = s * y + 1.0 / 120.0;
    s = s * y - 1.0 / 6.0;
    pp_lanes sine = angle + angle * y * s;
    pp_lanes c = 1.0 / 479001600.0 - 1.0 / 87178291200.0 * y;
    c = c * y - 1.0 / 3628800.0;
    c = c * y + 1.0 / 40320.0;
    c = c * y - 1.0 / 720.0;
    c = c * y + 1.0 / 24.0;
    c = c * y - 1.0 / 2.0;
    pp_lanes cosine = 1.0 + y * c;

    pp_lanes disc_x = r * PP_LANES_CHOOSE(is_a, cosine, sine);
    pp_lanes disc_y = r * PP_LANES_CHOOSE(is_a, sine, cosine);
    pp_lanes z2 = 1.0 - r * r, z;
    for (int lane = 0; lane < PP_LANES; lane++)
        z[lane] = z2[lane] > 0.0 ? sqrt(z2[lane]) : 0.0;
    pp_lanes x = frame->x.x * disc_x + frame->y.x * disc_y + frame->z.x * z;
    memcpy(to_x, &x, sizeof x);
    x = frame->x.y * disc_x + frame->y.y * disc_y + frame->z.y * z;
    memcpy(to_y, &x, sizeof x);
    x = frame->x.z * disc_x + frame->y.z * disc_y + frame->z.z * z;
    memcpy(to_z, &x, sizeof x);
}

PP_LANES_BODY void run(const struct pp_frame *frame, double u[2][PP_RUN_MOST],
                       int count, struct pp_lanes_directions *to)
{
    for (int at = 0; at < count; at += PP_LANES)
        sample(frame, u[0] + at, u[1] + at, to->x + at, to->y + at, to->z + at);
}

static void run_plain(const struct pp_frame *frame, double u[2][PP_RUN_MOST], int count,
                      struct pp_lanes_directions *to)
{
    run(frame, u, count, to);
}

PP_LANES_WIDE static void run_wide(const struct pp_frame *frame,
                                   double u[2][PP_RUN_MOST], int count,
                                   struct pp_lanes_directions *to)
{
    run(frame, u, count, to);
}

void pp_lobe_run(const struct pp_frame *frame, double u[2][PP_RUN_MOST], int count,
                 struct pp_lanes_directions *to)
{
    (pp_lanes_are_wide() ? run_wide : run_plain)(frame, u, count, to);
}
