/* common_error.h - the standard error of a sum of readings with correlated errors,
 * since points simulated together share some of their light.
 *
 * `common` is the correlated share of the readings' variance: 0 independent, 1 fully
 * correlated, each with its own standard error.
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
