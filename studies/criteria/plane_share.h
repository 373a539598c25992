/* plane_share.h - over how much of the plane a daylight factor is reached, of points
 * that were computed or sampled.
 */
#ifndef PP_STUDIES_CRITERIA_PLANE_SHARE_H
#define PP_STUDIES_CRITERIA_PLANE_SHARE_H

#include "model/base/error.h"
#include "model/results/reading.h"

struct pp_plane_share {
    double level;     /* daylight factor that the part of the points reaches: of half of
                       * them the median */
    double std_error; /* of it; NAN where nothing was sampled */
    double over;      /* share of the points that reach the target */
    double probability; /* that the part of them does; NAN where nothing was sampled */
};

/* Of `count` points (1 or more), all with values, `part` (above 0 to 1) is to reach
 * `target`: the least number of points that is as much or more.
 *
 * Points are taken as independent and normal with their standard errors, so that how
 * many of them reach a level is a sum of unlike coin tosses, whose distribution is
 * worked out without approximation. `level` is the k-th largest value for the least
 * number k, and its standard error half the distance between the levels that are
 * reached with probabilities of 16 and 84 %. What the grid itself leaves out is not
 * in it. */
enum pp_status pp_plane_share(struct pp_plane_share *share,
                              const struct pp_reading *points, int count, double part,
                              double target, struct pp_error *err);

#endif
