/* expression_value.c - evaluates operations in postfix order on a stack. */
#include "model/expression/expression_value.h"

#include <math.h>
#include <stddef.h>

#include "model/geometry/vec.h"

double pp_expression_value_call(enum pp_operation_kind kind, const double *list,
                                int count)
{
    double value = list[0];
    switch (kind) {
    case PP_DO_SQRT:
        return sqrt(value);
    case PP_DO_EXP:
        return exp(value);
    case PP_DO_LN:
        return log(value);
    case PP_DO_LOG10:
        return log10(value);
    case PP_DO_ABS:
        return fabs(value);
    case PP_DO_SIN:
        return sin(value * PP_RAD);
    case PP_DO_COS:
        return cos(value * PP_RAD);
    case PP_DO_TAN:
        return tan(value * PP_RAD);
    case PP_DO_ASIN:
        return asin(value) / PP_RAD;
    case PP_DO_ACOS:
        return acos(value) / PP_RAD;
    case PP_DO_ATAN:
        return atan(value) / PP_RAD;
    case PP_DO_FLOOR:
        return floor(value);
    case PP_DO_MOD:
        return value - list[1] * floor(value / list[1]);
    default:
        break;
    }
    for (int i = 1; i < count; i++)
        value = kind == PP_DO_MIN   ? fmin(value, list[i])
                : kind == PP_DO_MAX ? fmax(value, list[i])
                                    : value + list[i];
    return value;
}

static const char *fault_of(enum pp_operation_kind kind, double result, double last)
{
    if (kind == PP_DO_OVER && last == 0.0)
        return "divides by zero";
    if (kind == PP_DO_SQRT && last < 0.0)
        return "takes the square root of a negative number";
    if (isfinite(result))
        return NULL;
    return kind >= PP_DO_SQRT ? "uses a function outside its range"
                              : "does not have a finite result";
}

double pp_expression_value(const struct pp_expression *expression, const double *values,
                           struct pp_expression_fault *fault)
{
    /* Stack of values; `last` is the topmost one. */
    double below[PP_EXPRESSION_OPERATIONS_MOST + 1], last = NAN, *top = below;
    if (fault)
        *fault = (struct pp_expression_fault){NULL, 0};
    const struct pp_operation *end = expression->list + expression->count;
    for (const struct pp_operation *operation = expression->list; operation < end;
         operation++) {
        enum pp_operation_kind kind = operation->kind;
        double divisor = last;
        switch (kind) {
        case PP_DO_NUMBER:
            *top++ = last;
            last = operation->number;
            continue;
        case PP_DO_NAME:
            *top++ = last;
            last = values[operation->name];
            continue;
        case PP_DO_PLUS:
            last = *--top + last;
            break;
        case PP_DO_MINUS:
            last = *--top - last;
            break;
        case PP_DO_TIMES:
            last = *--top * last;
            break;
        case PP_DO_OVER:
            last = *--top / last;
            break;
        case PP_DO_POWER:
            last = pow(*--top, last);
            break;
        case PP_DO_NEGATIVE:
            last = -last;
            break;
        default:
            *top = last;
            top -= operation->count - 1;
            last = pp_expression_value_call(kind, top, operation->count);
        }
        if (fault && !fault->what && (kind == PP_DO_OVER || !isfinite(last))) {
            fault->what = fault_of(kind, last, divisor);
            fault->column = operation->column;
        }
    }
    return last;
}
