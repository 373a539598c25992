/* expression.h - the right side of a formula, as printed, parsed once and evaluated any
 * number of times.
 *
 *     sum     = product { (+|-) product }
 *     product = power { [*|/] power }        from left to right; without sign: times
 *     power   = [-] power | primary [ ^ power ]
 *     primary = number | name | function ( sum {, sum} ) | ( sum )
 *
 * A leading minus binds less tightly than ^ and more tightly than *. A name is a letter
 * followed by letters, digits, _ and '. Functions: sqrt, exp, ln, log10, abs; sin, cos,
 * tan of degrees; asin, acos, atan in degrees; floor; mod(a, b) = a - b floor(a / b);
 * min, max, sum of any number of arguments. The only constant is pi. There are no
 * assignments, loops or files.
 *
 * Each quantity has a dimension (dimension.h). Terms of a sum must have the same one.
 */
#ifndef PP_MODEL_EXPRESSION_EXPRESSION_H
#define PP_MODEL_EXPRESSION_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>

#include "model/expression/dimension.h"

enum {
    PP_EXPRESSION_MOST = 200, /* bytes of the text */
    /* Each byte of the text gives at most one number, name or sign, and one implied
     * product. */
    PP_EXPRESSION_OPERATIONS_MOST = 2 * PP_EXPRESSION_MOST,
    PP_EXPRESSION_NAMES_MOST = 24, /* different names */
    PP_EXPRESSION_NESTED_MOST = 64 /* nesting of parentheses, powers and signs */
};

/* A quantity that an expression may use. */
struct pp_expression_name {
    const char *symbol;
    struct pp_dimension dimension;
};

enum pp_operation_kind {
    PP_DO_NUMBER,
    PP_DO_NAME,
    PP_DO_PLUS,
    PP_DO_MINUS,
    PP_DO_TIMES,
    PP_DO_OVER,
    PP_DO_POWER,
    PP_DO_NEGATIVE,
    PP_DO_SQRT, /* first function; order as in `functions` */
    PP_DO_EXP,
    PP_DO_LN,
    PP_DO_LOG10,
    PP_DO_ABS,
    PP_DO_SIN,
    PP_DO_COS,
    PP_DO_TAN,
    PP_DO_ASIN,
    PP_DO_ACOS,
    PP_DO_ATAN,
    PP_DO_FLOOR,
    PP_DO_MOD, /* the only function of exactly two arguments */
    PP_DO_MIN,
    PP_DO_MAX,
    PP_DO_SUM
};

/* An operation, in postfix order. */
struct pp_operation {
    unsigned char kind;  /* enum pp_operation_kind */
    unsigned char count; /* of a function: number of arguments */
    short column;        /* position in the text, from 0 */
    union {
        double number;
        int name;
    };
};

struct pp_expression {
    int count;
    struct pp_operation list[PP_EXPRESSION_OPERATIONS_MOST];
    int name_count;                      /* number of different names used */
    int names[PP_EXPRESSION_NAMES_MOST]; /* indices in the list of names */
    struct pp_dimension dimension;       /* dimension of the result */
};

/* A mistake in a text; column: bytes before it. */
struct pp_expression_mistake {
    int column;
    char what[256]; /* "expected \")\" for the \"(\" in column 12" */
};

/* Parses the text. names: list of `count` valid names. shift: column of the text in the
 * user's input, added to columns in messages. False, with a mistake, if it is not an
 * expression of these names, is too long or too deeply nested, divides by a constant 0,
 * or has wrong dimensions. */
bool pp_expression_parse(struct pp_expression *expression, const char *text, int shift,
                         const struct pp_expression_name *names, int count,
                         struct pp_expression_mistake *mistake);

/* Names of the functions, NULL-terminated. */
const char *const *pp_expression_functions(void);

/* Number of bytes of the name that begins at text; 0: no name. */
int pp_expression_name_length(const char *text);

#endif
