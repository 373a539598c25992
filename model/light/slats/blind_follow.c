/* blind_follow.c - see blind_follow.h. */
#include "model/light/slats/blind_follow.h"

#include <math.h>
#include <string.h>

#include "model/light/slats/blind_scatter.h"

#define STEP_RAD (1.0 * PP_RAD)

double pp_blind_follow_tilt(const struct pp_slats *slats, double profile_rad)
{
    struct pp_slats turned = *slats;
    turned.tilt_rad = pp_slats_cut_off(slats, profile_rad);
    while (slats->rise != 0.0 && fabs(turned.tilt_rad) > STEP_RAD
           && !pp_slat_cell_fits(&turned))
        turned.tilt_rad -= copysign(STEP_RAD, turned.tilt_rad);
    return turned.tilt_rad;
}

static double profile_at(int index, int count)
{
    double p = -0.5 * PP_PI + index * PP_PI / count;
    return fmax(-89.9 * PP_RAD, fmin(p, 89.9 * PP_RAD));
}

/* Straight light of the sun, which arrives from outside. */
static double straight_of_sun(const void *data, struct pp_vec3 in)
{
    const struct pp_blind *blind = data;
    double p = atan2(blind->device.vertical ? -in.x : -in.y, in.z);
    double at = (p / PP_PI + 0.5) * PP_BLIND_SUNS;
    int i = (int)fmax(0.0, fmin(floor(at), PP_BLIND_SUNS - 1));
    double between = blind->straight_of_sun[i] * (1.0 - (at - i))
                     + blind->straight_of_sun[i + 1] * (at - i);
    return between * pp_glass_transmittance(&blind->outer, fabs(in.z))
           * pp_glass_transmittance(&blind->inner, fabs(in.z));
}

/* Takes the scattered light at each profile angle from a blind with its slats turned for
 * that angle. */
static enum pp_status turn_through(struct pp_blind *sun, const struct pp_glass *glass,
                                   bool upright, struct pp_error *err)
{
    struct pp_window_device device = sun->device;
    struct pp_blind *turned = NULL;
    enum pp_status status = PP_OK;
    for (int i = 0; i <= PP_BLIND_CELLS && status == PP_OK; i++) {
        double tilt =
            pp_blind_follow_tilt(&sun->device.slats, profile_at(i, PP_BLIND_CELLS));
        if (!turned || tilt != device.slats.tilt_rad) {
            pp_blind_release(turned);
            turned = NULL;
            device.slats.tilt_rad = tilt;
            status = pp_blind_create(&turned, &device, glass, upright, err);
        }
        if (status == PP_OK)
            memcpy(sun->through[i], turned->through[i], sizeof sun->through[i]);
    }
    pp_blind_release(turned);
    return status;
}

enum pp_status pp_blind_follow_create(struct pp_blind **blind,
                                      const struct pp_window_device *device,
                                      const struct pp_glass *glass, bool upright,
                                      struct pp_error *err)
{
    struct pp_window_device level = *device;
    level.slats.tilt_rad = 0.0;
    enum pp_status status = pp_blind_create(blind, &level, glass, upright, err);
    if (status == PP_OK)
        status = turn_through(*blind, glass, upright, err);
    if (status != PP_OK)
        return status;
    struct pp_blind *sun = *blind;
    for (int i = 0; i <= PP_BLIND_SUNS; i++) {
        double p = profile_at(i, PP_BLIND_SUNS);
        struct pp_slats turned = level.slats;
        turned.tilt_rad = pp_blind_follow_tilt(&level.slats, p);
        sun->straight_of_sun[i] = pp_slats_straight(&turned, p);
    }
    pp_blind_scatter_init(sun);
    sun->scatter.straight = straight_of_sun;
    return PP_OK;
}
