/* expression_value.h - the value of an expression for the values of its names. */
#ifndef PP_MODEL_RESULTS_EXPRESSION_VALUE_H
#define PP_MODEL_RESULTS_EXPRESSION_VALUE_H

#include "model/results/expression.h"

/* Evaluates the expression; values[i] is that of the i-th name of the list. A fault is
 * the first operation without a result, such as a division by 0. `what` is as in
 * "divides by nothing", static, with its column; NULL if there is none. fault may be
 * NULL. The result follows IEEE 754 in any case. */
struct pp_expression_fault {
    const char *what;
    int column;
};
double pp_expression_value(const struct pp_expression *expression, const double *values,
                           struct pp_expression_fault *fault);

/* Value of a function of its arguments, angles in degrees. */
double pp_expression_value_call(enum pp_operation_kind kind, const double *list,
                                int count);

#endif
