/* facade_sensitivity.h - would a verdict change if the facade were larger?
 *
 * A room's file need not say how far the walls round its windows go on (facade). A wall
 * that goes on takes sky from the ground before it, and light from whatever faces it, so
 * that a figure of the room by itself is rather too high. Where that is left out the room
 * is traced once more with walls that go on by 30 m; a verdict that is another one there
 * is not certain, whatever its noise.
 */
#ifndef PP_STUDIES_CRITERIA_FACADE_SENSITIVITY_H
#define PP_STUDIES_CRITERIA_FACADE_SENSITIVITY_H

#include "studies/criteria/assessment.h"

/* Share of the room's time for the other trace: at twice the standard error it is a
 * quarter of the work. */
#define PP_FACADE_SENSITIVITY_SHARE 0.2

/* Checks the sampled verdicts of an assessment by simulation: those that change lose their
 * confidence and get a note. No room is traced if there is no such verdict, or no wall to
 * extend. The trace takes its share of options->study->seconds. */
enum pp_status pp_facade_sensitivity_check(struct pp_assessment *assessment,
                                           const struct pp_assess_options *options,
                                           struct pp_error *err);

#endif
