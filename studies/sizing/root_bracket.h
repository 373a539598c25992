/* root_bracket.h - the largest argument at which a falling function is 0 or more.
 *
 * Method: the Illinois variant of false position. If the function jumps from above 0 to
 * below 0, the interval shrinks to the jump, and its lower end is the result.
 */
#ifndef PP_STUDIES_SIZING_ROOT_BRACKET_H
#define PP_STUDIES_SIZING_ROOT_BRACKET_H

#include "model/base/error.h"

typedef enum pp_status pp_root_bracket_value(void *context, double at, double *value,
                                             struct pp_error *err);

struct pp_root_bracket_range {
    double low, at_low;   /* an argument, and its value, which is not below 0 */
    double high, at_high; /* a greater argument, and its value, which is below 0 */
    double near_value;    /* values within this of 0 count as 0 */
    double near_argument; /* arguments that differ by at most this count as equal */
};

/* Finds the argument. The last call of the function is at *found. */
enum pp_status pp_root_bracket_find(double *found,
                                    const struct pp_root_bracket_range *range,
                                    pp_root_bracket_value *value_at, void *context,
                                    struct pp_error *err);

#endif
