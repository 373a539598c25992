/* larger_house.h - would a verdict turn if the room were part of a larger house?
 *
 * A room's file need not say how far the walls round its windows go on (facade). A wall
 * that goes on takes sky from the ground before it, and light from whatever faces it, so
 * that a figure of the room by itself is rather too high. Where that is left out the room
 * is traced once more with walls that go on by 30 m; a verdict that is another one there
 * is not certain, whatever its noise.
 */
#ifndef PP_STUDIES_CRITERIA_LARGER_HOUSE_H
#define PP_STUDIES_CRITERIA_LARGER_HOUSE_H

#include "studies/criteria/assessment.h"

/* Of the time that a room may take by the clock, the other trace's share: at twice the
 * standard error it is a quarter of the work. */
#define PP_LARGER_HOUSE_SHARE 0.2

/* Looks at the sampled verdicts of an assessment that has been judged by a simulation:
 * those that turn lose their confidence and get a note that says so. Nothing is traced
 * where there is no such verdict, or no wall to go on. The trace takes its share of
 * options->study->seconds. */
enum pp_status pp_larger_house_doubt(struct pp_assessment *assessment,
                                     const struct pp_assess_options *options,
                                     struct pp_error *err);

#endif
