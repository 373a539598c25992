/* reading.h - one method's value of one component, at a point or averaged over the
 * room. */
#ifndef PP_MODEL_RESULTS_READING_H
#define PP_MODEL_RESULTS_READING_H

#include <math.h>
#include "pepperpot.h"

static inline struct pp_reading pp_reading_of(double value)
{
    return (struct pp_reading){value, NAN, 0, 0};
}

static inline struct pp_reading pp_reading_none(const char *why)
{
    return (struct pp_reading){NAN, NAN, why, 0};
}

/* Standard error in per cent as it is printed: rounded up to two decimals, so that no
 * error is printed as 0. */
static inline double pp_reading_printed_error(const struct pp_reading *reading)
{
    return ceil(1e4 * reading->std_error - 1e-9) / 100.0 + 0.0; /* no -0 */
}

/* Difference of two sampled values over its standard error; 0 if they are equal without
 * error, NAN if an error is not known. */
static inline double pp_reading_apart(const struct pp_reading *reading,
                                      const struct pp_reading *other)
{
    double apart = reading->value - other->value;
    double error = hypot(reading->std_error, other->std_error);
    return apart == 0.0 && error == 0.0 ? 0.0 : apart / error;
}

#endif
