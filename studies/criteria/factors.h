/* factors.h - daylight factors used by criteria: simulated ones, or else those of a
 * hand method. */
#ifndef PP_STUDIES_CRITERIA_FACTORS_H
#define PP_STUDIES_CRITERIA_FACTORS_H

#include "studies/criteria/criterion.h"
#include "studies/criteria/grid/grid_error.h"
#include "studies/criteria/grid/plane_share.h"

/* Adds to a report, whose world and receivers the caller has set, the columns of
 * `average-df` and of `exact+bre` or, in rooms that `exact+bre` does not cover, of
 * `exact+split-flux` instead. */
enum pp_status pp_factors_by_hand(struct pp_report *report, struct pp_error *err);

/* Reason why criteria of daylight factors do not apply to the room: its sky is not
 * overcast. NULL if they apply. */
const char *pp_factors_refuse(const struct pp_inquiry *inquiry);

/* Daylight factors at the grid's points: the column "traced" if there is one, else that
 * of a hand method. NULL if there is none, with the reason in *why. The method is added
 * to the basis of the findings. */
const struct pp_column *pp_factors_of_grid(const struct pp_inquiry *inquiry,
                                           struct pp_finding_list *findings,
                                           const char **why);

/* Column whose average over the whole working plane is used: traced, else `average-df`,
 * else the hand method of the grid. NULL if there is none, with the reason in *why. */
const struct pp_column *pp_factors_average(const struct pp_inquiry *inquiry,
                                           struct pp_finding_list *findings,
                                           const char **why);

/* Range of the level that a part (a fraction) of the plane reaches: from all
 * points at the lower ends to all points at the upper ends of their bands. No range if
 * a point has no band. receivers: the areas of the points, as in plane_share.h. */
enum pp_status pp_factors_band(struct pp_band_ends *band,
                               const struct pp_column *column,
                               const struct pp_receiver *receivers, int count,
                               double part, struct pp_error *err);

/* Adds the error due to the grid to the error of the figure: sets std_error,
 * grid_error, over_error and the verdict. share, error: of the daylight factors at the
 * grid's points. scale: the finding's figure over share->level. */
void pp_factors_judge_share(struct pp_finding *finding,
                            const struct pp_plane_share *share,
                            const struct pp_grid_error *error, double scale);

/* Errors of the inquiry's grid; NAN if unknown. */
enum pp_status pp_factors_grid_error(struct pp_grid_error *error,
                                     const struct pp_inquiry *inquiry,
                                     const struct pp_column *column, double part,
                                     double target, struct pp_error *err);

#endif
