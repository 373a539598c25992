/* common_error.h - the standard error of a sum of readings whose errors are in part one and
 * the same: points that were traced together share some of the light that they found.
 *
 * `common` is the share of the readings' variance that they have in common, 0 (they are
 * independent) to 1 (they go wrong together, each by its own standard error).
 */
#ifndef PP_MODEL_RESULTS_COMMON_ERROR_H
#define PP_MODEL_RESULTS_COMMON_ERROR_H

#include <math.h>

/* Standard error of a sum, from the sum of the terms' standard errors and that of their
 * squares. */
static inline double pp_common_error(double sum, double squares, double common)
{
    return sqrt((1.0 - common) * squares + common * sum * sum);
}

#endif
