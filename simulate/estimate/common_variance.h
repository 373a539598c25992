/* common_variance.h - correlated fraction, 0 to 1, of the variance of a planner's
 * points (model/results/common_error.h). Points that share samples have correlated
 * errors. */
#ifndef PP_SIMULATE_ESTIMATE_COMMON_VARIANCE_H
#define PP_SIMULATE_ESTIMATE_COMMON_VARIANCE_H

#include "model/geometry/vec.h"
#include "simulate/estimate/planner.h"

enum { PP_COMMON_VARIANCE_NEAREST = 12 };

/* Common variance of the first `count` points. */
double pp_common_variance_of_all(const struct pp_planner *planner, int count);

/* Common variance of a point and its PP_COMMON_VARIANCE_NEAREST - 1 nearest neighbours,
 * averaged over points. places: positions of the points. */
double pp_common_variance_of_near(const struct pp_planner *planner,
                                  const struct pp_vec3 *places, int count);

#endif
