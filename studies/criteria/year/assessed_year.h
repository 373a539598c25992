/* assessed_year.h - the year of a weather file in an assessed room: daylight at points,
 * and glare of the room's views. */
#ifndef PP_STUDIES_CRITERIA_YEAR_ASSESSED_YEAR_H
#define PP_STUDIES_CRITERIA_YEAR_ASSESSED_YEAR_H

#include "studies/criteria/assessment.h"

/* Simulates the year's data that the chosen criteria need, if there is a weather file.
 * needed: a criterion needs the year at the room's own points. */
enum pp_status pp_assessed_year_simulate(struct pp_assessment *assessment,
                                         const bool chosen[PP_CRITERIA_MOST],
                                         bool needed,
                                         const struct pp_assess_options *options,
                                         struct pp_error *err);

#endif
