/* root_bracket.c - see root_bracket.h. */
#include "studies/sizing/root_bracket.h"

#include <math.h>

enum { STEPS_MOST = 60 };

enum pp_status pp_root_bracket_find(double *found,
                                    const struct pp_root_bracket_range *range,
                                    pp_root_bracket_value *value_at, void *context,
                                    struct pp_error *err)
{
    double low = range->low, high = range->high;
    double at_low = range->at_low, at_high = range->at_high, value;
    int side = 0;
    for (int step = 0; step < STEPS_MOST && !(high - low < range->near_argument);
         step++) {
        double middle = low + (high - low) * at_low / (at_low - at_high);
        enum pp_status status = value_at(context, middle, &value, err);
        *found = middle;
        if (status != PP_OK || fabs(value) < range->near_value)
            return status;
        if (value > 0.0) {
            low = middle;
            at_low = value;
            at_high *= side > 0 ? 0.5 : 1.0;
            side = 1;
        } else {
            high = middle;
            at_high = value;
            at_low *= side < 0 ? 0.5 : 1.0;
            side = -1;
        }
    }
    *found = low;
    return value_at(context, low, &value, err);
}
