/* common_error.h - the standard error of a sum of readings with correlated errors.
 *
 * Errors of points are correlated if the points are simulated together. `common` is the
 * correlated share of the variance of the readings, from 0 (independent) to 1 (fully
 * correlated). Each reading has its own standard error.
 */
#ifndef PP_MODEL_RESULTS_COMMON_ERROR_H
#define PP_MODEL_RESULTS_COMMON_ERROR_H

#include <math.h>

/* Standard error of a sum, from the sum of the terms' standard errors and the sum of
 * their squares. */
static inline double pp_common_error(double sum, double squares, double common)
{
    return sqrt((1.0 - common) * squares + common * sum * sum);
}

#endif
