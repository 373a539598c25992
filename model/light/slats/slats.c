/* slats.c - evaluates (1) and (2) in one form; flat slats are the limit of a large
 * radius. */
#include "model/light/slats/slats.h"

/* Angle A that the arc turns through from its crown to an edge; 0 for a flat slat. */
static double slat_half_turn(const struct pp_slats *slats)
{
    return 2.0 * atan(2.0 * fabs(slats->rise) / slats->width);
}

static double slat_radius(const struct pp_slats *slats)
{
    double rise = fabs(slats->rise);
    return (0.25 * slats->width * slats->width + rise * rise) / (2.0 * rise);
}

/* Largest value of cos(q - angle) for |q| <= half. */
static double largest_cosine(double angle, double half)
{
    angle = fabs(remainder(angle, 2.0 * PP_PI));
    return angle <= half ? 1.0 : cos(angle - half);
}

/* e(p): extent of a slat across the light (m). */
static double extent_across(const struct pp_slats *slats, double profile_rad)
{
    double turn = profile_rad - slats->tilt_rad, half = slat_half_turn(slats);
    if (half == 0.0)
        return slats->width * fabs(sin(turn));
    return slat_radius(slats)
           * (largest_cosine(turn, half) + largest_cosine(turn + PP_PI, half));
}

double pp_slats_straight(const struct pp_slats *slats, double profile_rad)
{
    double opening = slats->spacing * fabs(cos(profile_rad));
    return fmax(0.0, 1.0 - extent_across(slats, profile_rad) / opening);
}

double pp_slats_cut_off(const struct pp_slats *slats, double profile_rad)
{
    enum { STEPS = 1800, HALVINGS = 40 };
    struct pp_slats turned = *slats;
    double best = 0.0, least = INFINITY;
    double way = profile_rad > 0.0 ? -1.0 : 1.0, step = 0.5 * PP_PI / STEPS;

    for (int i = 0; i <= STEPS && least > 0.0; i++) {
        turned.tilt_rad = way * i * step;
        double straight = pp_slats_straight(&turned, profile_rad);
        if (straight < least) {
            least = straight;
            best = turned.tilt_rad;
        }
    }
    if (least > 0.0 || best == 0.0)
        return best;
    double open = best - way * step;
    for (int i = 0; i < HALVINGS; i++) {
        turned.tilt_rad = 0.5 * (open + best);
        if (pp_slats_straight(&turned, profile_rad) > 0.0)
            open = turned.tilt_rad;
        else
            best = turned.tilt_rad;
    }
    return best;
}

void pp_slats_point(const struct pp_slats *slats, double fraction, double *a, double *b)
{
    double along = (fraction - 0.5) * slats->width, over = 0.0;
    double half = slat_half_turn(slats);
    if (half > 0.0) {
        double radius = slat_radius(slats), q = (2.0 * fraction - 1.0) * half;
        along = radius * sin(q);
        over = copysign(radius * (cos(q) - cos(half)), slats->rise);
    }
    *a = along * cos(slats->tilt_rad) + over * sin(slats->tilt_rad);
    *b = over * cos(slats->tilt_rad) - along * sin(slats->tilt_rad);
}

double pp_slats_profile(struct pp_vec3 travel, struct pp_vec3 inwards,
                        struct pp_vec3 along)
{
    return atan2(-pp_vec_dot(travel, along), pp_vec_dot(travel, inwards));
}
