/* facade_sensitivity.h - checks whether a verdict would change with a larger facade.
 *
 * A room file need not state the extent of the walls around its windows (facade). A
 * larger wall hides sky from the ground in front of the wall and from surfaces that
 * face the wall, so that the figures of a room without facade are slightly too high. If
 * the facade is not given, the room is simulated again with walls extended by 30 m. If
 * a verdict then differs, the verdict is not certain, however small the noise.
 */
#ifndef PP_STUDIES_CRITERIA_FACADE_SENSITIVITY_H
#define PP_STUDIES_CRITERIA_FACADE_SENSITIVITY_H

#include "studies/criteria/assessment.h"

/* Time for simulating the room with extended walls, as a fraction of the time for the
 * room itself. With twice the standard error, that simulation needs a quarter of the
 * work. */
#define PP_FACADE_SENSITIVITY_SHARE 0.2

/* Checks by simulation those verdicts of an assessment that are based on sampled
 * figures. A verdict that changes loses its confidence and gets a note. Nothing is
 * simulated if there is no such verdict, or if there is no wall to extend and the
 * ground is not open. The time limit is PP_FACADE_SENSITIVITY_SHARE of
 * options->study->seconds. */
enum pp_status pp_facade_sensitivity_check(struct pp_assessment *assessment,
                                           const struct pp_assess_options *options,
                                           struct pp_error *err);

#endif
