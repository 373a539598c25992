/* reading.h - one method's value of one component, at a point or of the room. */
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

#endif
