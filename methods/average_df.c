/* average_df.c - `average-df`: average daylight factor over the working plane.
 *
 *     DF = T W theta M / (A (1 - R^2))   per cent                          [CL84]
 *
 *   T      diffuse transmittance of the glass, 1 for an unglazed opening
 *   W      net glass area (m2): opening area times frame factor
 *   theta  vertical angle of visible sky (degrees) at the middle of the opening, in the
 *          plane of the wall's inside: from the obstruction's angle up to the upper
 * edge of the reveal, atan(height/2 / reveal) M      maintenance factor A      area of
 * all inside surfaces, openings included (m2) R      their area-weighted mean
 * reflectance, openings with 0.1
 *
 * For vertical openings under the CIE overcast sky. Several openings add up, with the
 * common A and R. Nothing is left to allow for but decorations. The formula is not
 * meant for obstructions that one section angle does not describe; blocks are taken by
 * obstruction_angle.h.
 */
#include <stddef.h>

#include "methods/inside.h"
#include "methods/methods.h"
#include "methods/obstruction_angle.h"
#include "methods/refusals.h"

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    const char *why = pp_refuse_unless_overcast_and_up(world, receiver);
    return why ? why : pp_refuse_if_luminous(world);
}

static const char *refuses(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver)
{
    (void)world, (void)receiver;
    return pp_refuse_unless_vertical(opening);
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)receiver, (void)tools;
    double alpha_rad;
    enum pp_status status = pp_obstruction_angle(&alpha_rad, world, opening, err);
    if (status != PP_OK)
        return status;
    struct pp_inside all = pp_inside_all(world);

    double T = opening->glass.diffuse, M = opening->maintenance;
    double W = opening->inner.area_m2 * opening->frame_factor;
    double A = all.area_m2, R = all.reflectance;
    double head_rad = atan2(opening->height_m / 2.0, opening->reveal_m);
    double theta_deg = fmax(head_rad - alpha_rad, 0.0) / PP_RAD;
    part->value = T * W * theta_deg * M / (A * (1.0 - R * R)) / 100.0;
    return PP_OK;
}

const struct pp_method pp_method_average_df = {
    .name = "average-df",
    .summary = "average daylight factor over the working plane in one formula",
    .source = "CL84",
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
