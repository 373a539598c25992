/* facade_sensitivity.h - checks whether a verdict would change with a larger facade.
 *
 * A room file need not state how far the walls round its windows extend (facade). A
 * larger wall hides sky from the ground in front of it, and from surfaces that face it,
 * so figures of a room by itself are slightly too high. If the facade is not given, the
 * room is simulated again with walls extended by 30 m. A verdict that differs there is
 * not certain, however small its noise.
 */
#ifndef PP_STUDIES_CRITERIA_FACADE_SENSITIVITY_H
#define PP_STUDIES_CRITERIA_FACADE_SENSITIVITY_H

#include "studies/criteria/assessment.h"

/* Share of the room's time for simulating the other room: with twice the standard error
 * it needs a quarter of the work. */
#define PP_FACADE_SENSITIVITY_SHARE 0.2

/* Checks the sampled verdicts of an assessment by simulation: those that change lose their
 * confidence and get a note. No room is traced if there is no such verdict, or no wall to
 * extend. The trace takes its share of options->study->seconds. */
enum pp_status pp_facade_sensitivity_check(struct pp_assessment *assessment,
                                           const struct pp_assess_options *options,
                                           struct pp_error *err);

#endif
