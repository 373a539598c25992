/* bre.c - `bre`: average internally reflected component, BRE inter-reflection formula.
 *
 *     IRC = 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)   per cent   [HLP54], [BRE310]
 *
 *   W     net glass area (m2): opening area times frame factor
 *   A     area of all inside surfaces, openings included (m2)
 *   R     their area-weighted mean reflectance, openings with 0.1
 *   R_fw  mean reflectance of floor and walls below the middle of the opening's height
 *   R_cw  the same of ceiling and walls above it; both without the opening's own wall
 *   C     factor of the outside obstruction (per cent), obstruction_factor.h
 *
 * As given in [GEEBELEN]. 5 is the ground's share: reflectance 0.1, half of it seen.
 * 0.85 is the diffuse transmittance of clear single glass. Several openings add up,
 * each with its own W, C, R_fw and R_cw and the common A and R; in these two means the
 * other walls' openings count with 0.1.
 *
 * For vertical openings under the CIE overcast sky. It contains clear single glass and,
 * through W, the frame; no dirt, no deterioration of decorations.
 */
#include <stddef.h>

#include "methods/inside.h"
#include "methods/methods.h"
#include "methods/obstruction_angle.h"
#include "methods/obstruction_factor.h"
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
    struct pp_inside_parts parts =
        pp_inside_split_without(world, opening->middle_z_m, opening->face);

    double W = opening->inner.area_m2 * opening->frame_factor;
    double A = all.area_m2, R = all.reflectance;
    double R_fw = parts.lower.reflectance, R_cw = parts.upper.reflectance;
    double C = pp_obstruction_factor(alpha_rad);
    part->value = 0.85 * W / (A * (1.0 - R)) * (C * R_fw + 0.05 * R_cw);
    return PP_OK;
}

const struct pp_method pp_method_bre = {
    .name = "bre",
    .summary = "average internally reflected component, BRE inter-reflection formula",
    .source = "BRE310",
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = refuses_room,
    .refuses = refuses,
    .evaluate = evaluate,
};
