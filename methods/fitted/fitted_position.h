/* fitted_position.h - how the internally reflected component varies over the working
 * plane: with the distance from the window's wall, and sideways.
 *
 * A room that is deep relative to its height and width acts as a light pipe. Reflected
 * light spreads along the room by diffusion and loses the fraction 1 - R at each
 * reflection. This light falls off exponentially over a range l / sqrt(1 - R), where l
 * is twice the area of the room's section divided by half the section's perimeter. The
 * fall begins c l / k behind the window's wall, where the light from outside first
 * lands. A room of just that depth is as bright at its back as near the window, a
 * shallower one is brighter at its back:
 *
 *     l = 2 w_r h_r / (w_r + h_r)
 *     f_d = q_d exp(-q_d x / d_r) / (1 - exp(-q_d)),   q_d = sqrt(1 - R) (k d_r / l - c) (1)
 *     f_s = q_s exp(-2 q_s y / w_r) / (1 - exp(-q_s)),
 *                                                 q_s = s (w_r - w) sqrt(1 - R) / l      (2)
 *
 * Sideways, the width of wall beside the opening matters: an opening as wide as its
 * wall lights the room evenly from side to side.
 *
 * The mean of (1) over the depth is 1. For an opening in the middle of its wall, the
 * mean of (2) over the breadth is 1. As R approaches 1, both approach 1 (the light in a
 * furnace is the same everywhere). In an infinitely deep room (1) falls to 0. k, c and
 * s are fitted [ATLAS].
 *
 *   x, y      distances from the opening's wall, and from its middle along the wall
 *   d_r, w_r  the room's depth and breadth, perpendicular to that wall and along it
 *   h_r       the room's height
 *   w         breadth of the opening
 *
 * A point behind the plane of the opening's wall is treated as if in that plane.
 */
#ifndef PP_METHODS_FITTED_FITTED_POSITION_H
#define PP_METHODS_FITTED_FITTED_POSITION_H

#include "model/results/worksheet.h"
#include "model/room/world.h"

/* Rows of a formula's list of quantities. */
#define PP_FITTED_POSITION_QUANTITIES                                                  \
    {"f_d", PP_UNIT_NUMBER,                                                            \
     "factor for the distance of the point from the wall with the opening, relative "  \
     "to the mean"},                                                                   \
    {                                                                                  \
        "f_s", PP_UNIT_NUMBER,                                                         \
            "factor for the position of the point along the wall, relative to the "    \
            "mean"                                                                     \
    }

/* Rows of a method's list of formulae. */
extern const struct pp_formula pp_fitted_position_l, pp_fitted_position_q_d,
    pp_fitted_position_m_d, pp_fitted_position_f_d, pp_fitted_position_q_s,
    pp_fitted_position_f_s;
#define PP_FITTED_POSITION_FORMULAE                                                    \
    &pp_fitted_position_l, &pp_fitted_position_q_d, &pp_fitted_position_m_d,           \
        &pp_fitted_position_f_d, &pp_fitted_position_q_s, &pp_fitted_position_f_s

/* Quantities of (1) and (2) for one opening and receiver. */
struct pp_fitted_place {
    double d_r, w_r, h_r, x, y; /* m */
};
struct pp_fitted_place pp_fitted_position_of(const struct pp_world *world,
                                             const struct pp_opening *opening,
                                             const struct pp_receiver *receiver);

/* Records d_r, w_r and h_r. */
void pp_fitted_position_put_room(struct pp_worksheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening);

/* Adds the last steps of a component that varies with position. Calculates the mean
 * over the working plane. Records f_d, f_s and their quantities, except those already
 * on the sheet (R and, at a point, the room's extents and w). Calculates and returns
 * the value at the point. Without a receiver, f_d and f_s are 1, which is their mean
 * over the working plane. */
double pp_fitted_position_work(struct pp_worksheet *sheet,
                               const struct pp_formula *mean,
                               const struct pp_formula *at_point,
                               const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver);

#endif
