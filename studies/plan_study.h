/* plan_study.h - data of a plan of a room's daylight: contours over the working plane,
 * figures at the room's points, and those of the plane, all by one method or all
 * simulated. */
#ifndef PP_STUDIES_PLAN_STUDY_H
#define PP_STUDIES_PLAN_STUDY_H

#include "model/results/daylight_plan.h"
#include "model/results/report.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

struct pp_plan_study {
    struct pp_daylight_plan plan;
    struct pp_report report;  /* report of the room's points; with grid_points, of
                               * the plane */
    struct pp_column figures; /* figures at the report's receivers, and `plane` */
    char note[320]; /* states that another method replaces the usual one, or the hand
                     * figures to compare simulated ones with; may be empty */
};

/* Checks that a plan can show this choice: the daylight factor of one direct method or
 * of one pair; or, with simulate and without methods, the simulated one. Methods that
 * count squares or dots, with values in steps, and those that give one value for the
 * room have no contours. methods NULL: the usual pair of the room. PP_BAD_INPUT says
 * what is wrong. */
enum pp_status pp_plan_study_check(const char *methods, bool simulate,
                                   struct pp_error *err);

/* Fills study (to be cleared; empty on failure). PP_BAD_INPUT also where the method does not
 * cover the room. *by_clock: as in studies/study_report.h. */
enum pp_status pp_plan_study_make(struct pp_plan_study *study,
                                  const struct pp_study_room *room,
                                  const struct pp_study_options *options,
                                  bool *by_clock, struct pp_error *err);

/* Makes a plan by hand methods for the screen: with contours to the given tolerance (m,
 * above 0), and without the grid over the plane. */
enum pp_status pp_plan_study_sketch(struct pp_plan_study *study,
                                    const struct pp_study_room *room,
                                    const struct pp_study_options *options,
                                    double tolerance_m, struct pp_error *err);
void pp_plan_study_clear(struct pp_plan_study *study);

#endif
