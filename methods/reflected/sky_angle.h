/* sky_angle.h - theta of the formulae of the average daylight factor: the angle of
 * visible sky in the vertical section through the middle of an opening.
 *
 * theta is measured at the inner face of the wall, from the obstruction angle alpha
 * (reflected/obstruction.h) up to the head of the reveal. For vertical glass without a
 * reveal theta is 90 degrees less alpha, for sloping glass 180 degrees less the slope
 * beta and alpha. Losses in a well are represented by the well's efficiency (well.h).
 * For horizontal glass alpha is 90 degrees times the fraction of the sky's light that
 * is hidden, and is subtracted on both sides; theta is 0 if all of the sky is hidden.
 */
#ifndef PP_METHODS_REFLECTED_SKY_ANGLE_H
#define PP_METHODS_REFLECTED_SKY_ANGLE_H

#include "model/light/outside_light.h"
#include "model/results/worksheet.h"
#include "model/room/world.h"

extern const struct pp_formula pp_sky_angle_head, pp_sky_angle_upper[2],
    pp_sky_angle_theta;

/* Rows of a method's list of formulae: for vertical glass, and for any other. */
#define PP_SKY_ANGLE_FORMULAE &pp_sky_angle_head, &pp_sky_angle_theta
#define PP_SKY_ANGLE_SLOPING_FORMULAE &pp_sky_angle_upper[0], &pp_sky_angle_upper[1]

/* Records theta and its quantities, always including theta_h and alpha. */
enum pp_status pp_sky_angle(struct pp_worksheet *sheet, const struct pp_world *world,
                            const struct pp_outside_light *light,
                            const struct pp_opening *opening, struct pp_error *err);

/* Records theta_h of a vertical opening: the altitude of the head of its reveal. */
void pp_sky_angle_head_of(struct pp_worksheet *sheet, const struct pp_opening *opening);

#endif
