/* plane_share.h - over which share of the plane a daylight factor is reached, and with
 * which probability, by points that were computed or sampled.
 */
#ifndef PP_STUDIES_CRITERIA_GRID_PLANE_SHARE_H
#define PP_STUDIES_CRITERIA_GRID_PLANE_SHARE_H

#include "model/base/error.h"
#include "model/results/reading.h"

struct pp_plane_share {
    double level;      /* daylight factor that the given part of the points reaches; for
                       * half of the points their median, which is the mean of the two
                       * middle values of an even number */
    double std_error;  /* of level; NAN where nothing was sampled */
    double over;       /* share of the points that reach the target */
    double over_error; /* its standard error; NAN where nothing was sampled */
    double probability; /* that the given part of the points reaches the target; NAN if
                         * nothing was sampled */
};

/* Share of `count` points (1 or more), all with values, of which the part `part` (above
 * 0, at most 1) should reach `target`: k points, the least number that is that part or
 * more. Half of them (a part of 0.5) reach it where their median does.
 *
 * Points are normal with their standard errors, of whose squares they have the share
 * `common` in common (common_error.h) and are independent else. Given what is common, the
 * number of points that reach a level has the Poisson binomial distribution (a sum of
 * unlike coin tosses). It is computed without approximation for 200 points that may reach
 * the level or miss it, and as a normal one, to 0.002, for more; over what is common it is
 * a sum whose steps are as fine as it is steep. `level` is the k-th largest value, or the
 * median; its standard error is half the distance between the levels that are reached with
 * probabilities of 16 and 84 %. The error that the grid's spacing makes is not
 * included. */
enum pp_status pp_plane_share(struct pp_plane_share *share,
                              const struct pp_reading *points, int count, double common,
                              double part, double target, struct pp_error *err);

#endif
