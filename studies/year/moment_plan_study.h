/* moment_plan_study.h - computes the illuminances on a room's working plane at one
 * moment. */
#ifndef PP_STUDIES_YEAR_MOMENT_PLAN_STUDY_H
#define PP_STUDIES_YEAR_MOMENT_PLAN_STUDY_H

#include "model/results/sheets/moment_plan.h"
#include "studies/study_room.h"
#include "studies/year/moment.h"

/* Fills a plan with cells of 0.25 m, or larger ones if the rectangle around the plane
 * is above 37.5 m2. options: paths or the error of the room's own points; cells have
 * four times that error. The room must outlive *plan. The caller clears *plan, even
 * after a failure. PP_BAD_INPUT if the room has no working plane; PP_INTERRUPTED if the
 * watch stopped the computation, in which case there is no plan. */
enum pp_status pp_moment_plan_study_make(struct pp_moment_plan *plan,
                                         const struct pp_study_room *room,
                                         const struct pp_moment *moment,
                                         const struct pp_annual_options *options,
                                         struct pp_error *err);
void pp_moment_plan_study_clear(struct pp_moment_plan *plan);

#endif
