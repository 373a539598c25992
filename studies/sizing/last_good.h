/* last_good.h - how far something may go: the last argument at which a value that falls is
 * not below 0.
 *
 * By the Illinois variant of false position; where the value falls by a step through 0, by
 * what is left of the interval, of which the good end is the answer.
 */
#ifndef PP_STUDIES_SIZING_LAST_GOOD_H
#define PP_STUDIES_SIZING_LAST_GOOD_H

#include "model/base/error.h"

typedef enum pp_status pp_last_good_value(void *context, double at, double *value,
                                          struct pp_error *err);

struct pp_last_good_range {
    double low, at_low;   /* an argument, and a value that is not below 0 */
    double high, at_high; /* a greater one, and a value below 0 */
    double near_value;    /* so near to 0, above or below, a value is 0 */
    double near_argument; /* so near, two arguments are one */
};

/* The last call of the function is that at *found. */
enum pp_status pp_last_good_find(double *found, const struct pp_last_good_range *range,
                                 pp_last_good_value *value_at, void *context,
                                 struct pp_error *err);

#endif
