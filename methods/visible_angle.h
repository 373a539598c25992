/* visible_angle.h - the angle of sky that an opening sees, as the formulae of the
 * average daylight factor take it. */
#ifndef PP_METHODS_VISIBLE_ANGLE_H
#define PP_METHODS_VISIBLE_ANGLE_H

#include "model/results/steps.h"
#include "model/room/world.h"

/* theta: in the vertical section through the middle of a vertical opening, in the plane
 * of the wall's inside, from the obstruction's angle up to the head of the reveal. */
struct pp_visible_angle {
    double head_rad;  /* up to which sky could be seen: 90 degrees without a reveal */
    double alpha_rad; /* of the obstruction (obstruction_angle.h) */
    double theta_rad; /* head less alpha, 0 where that is less */
};

enum pp_status pp_visible_angle(struct pp_visible_angle *angle,
                                const struct pp_world *world,
                                const struct pp_opening *opening, struct pp_error *err);

/* Sets down theta and what it comes of. steps may be NULL. */
void pp_visible_angle_steps(struct pp_steps *steps,
                            const struct pp_visible_angle *angle,
                            const struct pp_opening *opening);

#endif
