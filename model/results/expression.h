/* expression.h - the right side of a formula as printed, parsed once and evaluated any
 * number of times.
 *
 *     sum     = product { (+|-) product }
 *     product = power { [*|/] power }        from left to right; side by side: times
 *     power   = [-] power | primary [ ^ power ]
 *     primary = number | name | function ( sum {, sum} ) | ( sum )
 *
 * A minus binds looser than ^ and tighter than *. A name is a letter followed by
 * letters, digits, _ and '. Functions: sqrt, exp, ln, log10, abs; sin, cos, tan of
 * degrees; asin, acos, atan to degrees; min, max, sum of any number of arguments. pi is
 * predefined. There is nothing else: no assignment, no loop, no file.
 *
 * Each quantity has a dimension (dimension.h), which is checked: terms of a sum must
 * have the same one.
 */
#ifndef PP_MODEL_RESULTS_EXPRESSION_H
#define PP_MODEL_RESULTS_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>

#include "model/results/dimension.h"

enum {
    PP_EXPRESSION_MOST = 200, /* bytes of its text */
    /* A byte is at most one number, name or sign; two side by side are one product. */
    PP_EXPRESSION_OPERATIONS_MOST = 2 * PP_EXPRESSION_MOST,
    PP_EXPRESSION_NAMES_MOST = 24, /* different names in it */
    PP_EXPRESSION_NESTED_MOST = 64 /* parentheses, powers and signs within another */
};

/* A quantity that an expression may name. */
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
    PP_DO_SQRT, /* functions from here on, in the order of `functions` */
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
    PP_DO_MIN,
    PP_DO_MAX,
    PP_DO_SUM
};

/* A step of the work, in postfix order. */
struct pp_operation {
    unsigned char kind;  /* enum pp_operation_kind */
    unsigned char count; /* number of arguments of a function with any number of them */
    short column;        /* in the text, from 0 */
    union {
        double number;
        int name;
    };
};

struct pp_expression {
    int count;
    struct pp_operation list[PP_EXPRESSION_OPERATIONS_MOST];
    int name_count;                      /* of the names that occur in it */
    int names[PP_EXPRESSION_NAMES_MOST]; /* their indices in the list of names */
    struct pp_dimension dimension;       /* of the result */
};

/* Mistake in a text, and its place: the column counts bytes from 0. */
struct pp_expression_mistake {
    int column;
    char what[256]; /* "expected \")\", for the \"(\" in column 12" */
};

/* Parses the text, whose names are those of the list of `count`. `shift` is added to
 * the columns in messages: the column of the text in the user's input. False, with a
 * mistake, if it is not an expression of these names, is too long, divides by 0, or
 * adds different dimensions. */
bool pp_expression_parse(struct pp_expression *expression, const char *text, int shift,
                         const struct pp_expression_name *names, int count,
                         struct pp_expression_mistake *mistake);

/* The functions, for lists; ends with NULL. */
const char *const *pp_expression_functions(void);

/* Number of bytes of the name at text; 0: no name begins there. */
int pp_expression_name_length(const char *text);

#endif
