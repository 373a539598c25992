/* expression_value.h - evaluates an expression for given values of its names. */
#ifndef PP_MODEL_EXPRESSION_EXPRESSION_VALUE_H
#define PP_MODEL_EXPRESSION_EXPRESSION_VALUE_H

#include "model/expression/expression.h"

/* Evaluates the expression; values[i] is the value of the i-th name of the list. The
 * result follows IEEE 754 in any case. *fault (may be NULL) is set to the first
 * operation without a result, such as a division by 0. what: the reason ("divides by
 * zero"), static; NULL if all operations have a result. column: position in the
 * text. */
struct pp_expression_fault {
    const char *what;
    int column;
};
double pp_expression_value(const struct pp_expression *expression, const double *values,
                           struct pp_expression_fault *fault);

/* Value of a function for its arguments; angles are in degrees. */
double pp_expression_value_call(enum pp_operation_kind kind, const double *list,
                                int count);

#endif
