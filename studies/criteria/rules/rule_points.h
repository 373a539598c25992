/* rule_points.h - the points at which a rule requires a daylight factor. */
#ifndef PP_STUDIES_CRITERIA_RULES_RULE_POINTS_H
#define PP_STUDIES_CRITERIA_RULES_RULE_POINTS_H

#include "model/results/report.h"
#include "studies/study_room.h"

/* Makes the points for a word in the column `point` of the table, and a report on their
 * daylight factors by hand methods, with bands:
 *   file        the points of the room file; not those of the default grid
 *   half-depth  on the working plane, at half of the depth from the window wall, 1 m
 *               from each side wall
 * No points are made if the room file has none (file), or if the room is not a
 * rectangle more than 2 m wide with windows in one wall (half-depth). The caller clears
 * *report and frees *points, even after a failure. */
enum pp_status pp_rule_points_report(struct pp_report *report,
                                     struct pp_receiver **points,
                                     const struct pp_study_room *room, const char *word,
                                     struct pp_error *err);

#endif
