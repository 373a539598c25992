/* factors.h - the daylight factors that criteria rest on: traced ones, or else those of
 * hand methods.
 */
#ifndef PP_STUDIES_CRITERIA_FACTORS_H
#define PP_STUDIES_CRITERIA_FACTORS_H

#include "studies/criteria/criterion.h"

/* Adds to a report, of which the caller has set world and receivers, the columns of
 * `average-df`, of `exact+bre` and, where that does not cover the room, of
 * `exact+split-flux`. */
enum pp_status pp_factors_by_hand(struct pp_report *report, struct pp_error *err);

/* Why the overcast sky's criteria do not speak of this room: its sky is another; NULL
 * if they do. */
const char *pp_factors_refuse(const struct pp_inquiry *inquiry);

/* The daylight factors of the grid: the column "traced" if there is one, else that of a
 * hand method. NULL where there is none, and *why says so. The basis of the findings is
 * set to what they rest on. */
const struct pp_column *pp_factors_of_grid(const struct pp_inquiry *inquiry,
                                           struct pp_finding_list *findings,
                                           const char **why);

/* The average over the whole working plane: traced, else by `average-df`, else of the
 * grid's hand method. NULL where there is none. */
const struct pp_reading *pp_factors_average(const struct pp_inquiry *inquiry,
                                            struct pp_finding_list *findings,
                                            const char **why);

#endif
