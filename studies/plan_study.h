/* plan_study.h - data for a plan of the daylight in a room: contours over the working
 * plane, values at the room's points, and figures of the plane. All are by the same
 * method or simulated. */
#ifndef PP_STUDIES_PLAN_STUDY_H
#define PP_STUDIES_PLAN_STUDY_H

#include "model/results/daylight_plan.h"
#include "model/results/report.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

struct pp_plan_study {
    struct pp_daylight_plan plan;
    struct pp_report report;  /* report at the room's points */
    struct pp_column figures; /* values at the receivers of the report, and figures of
                               * the plane */
    char note[320]; /* states that another method replaces the usual one, or, for
                     * simulated values, values by hand for comparison; may be empty */
};

/* Checks that a plan can show these methods: one direct method or one pair; methods
 * NULL: the usual pair for the room, or, if `simulate` is set, the simulation. Some
 * methods have no contours: those that count squares or dots, whose values change in
 * steps, and those that give one value for the room. PP_BAD_INPUT: the message gives
 * the reason. */
enum pp_status pp_plan_study_check(const char *methods, bool simulate,
                                   struct pp_error *err);

/* Makes a plan. The caller clears *study, which is empty after a failure. PP_BAD_INPUT
 * also if the method does not apply to the room. *by_clock: as in
 * studies/study_report.h. */
enum pp_status pp_plan_study_make(struct pp_plan_study *study,
                                  const struct pp_study_room *room,
                                  const struct pp_study_options *options,
                                  bool *by_clock, struct pp_error *err);

/* Makes a plan by hand methods for the screen. Contours have the tolerance given (m,
 * greater than 0). There is no grid over the plane. */
enum pp_status pp_plan_study_sketch(struct pp_plan_study *study,
                                    const struct pp_study_room *room,
                                    const struct pp_study_options *options,
                                    double tolerance_m, struct pp_error *err);
void pp_plan_study_clear(struct pp_plan_study *study);

#endif
