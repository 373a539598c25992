/* plane_share.h - fraction of the plane on which a daylight factor is reached, with
 * probabilities, from points that were computed or sampled. */
#ifndef PP_STUDIES_CRITERIA_GRID_PLANE_SHARE_H
#define PP_STUDIES_CRITERIA_GRID_PLANE_SHARE_H

#include "model/base/error.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_plane_share {
    double level;       /* daylight factor that the given part of the plane reaches; for
                        * one half, the median (of an even number of points with equal
                        * areas, the mean of the middle two) */
    double std_error;   /* error of level; NAN if nothing was sampled */
    double over;        /* fraction of the plane whose points reach the target */
    double over_error;  /* standard error of `over`; NAN if nothing was sampled */
    double probability; /* probability that the given part of the points reaches the
                         * target; NAN if nothing was sampled */
};

/* Fraction of `count` points (1 or more, all with values) that reach `target`. `part`
 * (above 0, at most 1) is the fraction that should reach the target: k points, rounded
 * up. For a part of 0.5 the target is compared with the median. receivers: the points'
 * areas (area_m2), by which each counts; NULL, or without areas: all count equally.
 *
 * The values of points are normally distributed with their standard errors. The
 * fraction `common` of the variance is due to an error that all points have in common
 * (common_error.h); the rest is independent. Given the common error, the number of
 * points that reach a level has the Poisson binomial distribution (a sum of independent
 * events with different probabilities). This distribution is computed exactly for up to
 * 200 uncertain points of equal areas, or 50 of different ones. For more points it is
 * approximated by a normal distribution, which for more than 200 is correct to 0.002.
 * The integral over the common error has steps that are finer where the integrand is
 * steep. `level` is the k-th largest value, or the median; its standard error is half
 * the distance between the levels that are reached with probabilities of 16 and 84 %.
 * The error due to the grid's spacing is not included. */
enum pp_status pp_plane_share(struct pp_plane_share *share,
                              const struct pp_reading *points,
                              const struct pp_receiver *receivers, int count,
                              double common, double part, double target,
                              struct pp_error *err);

/* Mean over the plane of the values of `count` points, each weighted by its area, and
 * its standard error. receivers, common: as above. */
struct pp_reading pp_plane_share_mean(const struct pp_reading *points,
                                      const struct pp_receiver *receivers, int count,
                                      double common);

#endif
