/* root_bracket.h - the largest argument at which a decreasing function is at least 0.
 *
 * The method is the Illinois variant of false position. If the function jumps from a
 * positive to a negative value, the interval shrinks to the jump, and its lower end is
 * the result.
 */
#ifndef PP_STUDIES_SIZING_ROOT_BRACKET_H
#define PP_STUDIES_SIZING_ROOT_BRACKET_H

#include "model/base/error.h"

typedef enum pp_status pp_root_bracket_value(void *context, double at, double *value,
                                             struct pp_error *err);

struct pp_root_bracket_range {
    double low, at_low;   /* an argument with a value of at least 0 */
    double high, at_high; /* a greater argument with a value below 0 */
    double near_value;    /* a value whose distance from 0 is at most this is treated as
                           * 0 */
    double near_argument; /* arguments whose difference is at most this are treated as
                           * equal */
};

/* Finds the argument. The function is called last at *found. */
enum pp_status pp_root_bracket_find(double *found,
                                    const struct pp_root_bracket_range *range,
                                    pp_root_bracket_value *value_at, void *context,
                                    struct pp_error *err);

#endif
