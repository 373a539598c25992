/* variant.h - a published formula modified by the user, which gets its own column next
 * to that of the original.
 *
 *     irc = 0.83 W / (A (1 - R)) (C R_fw + 5 R_cw)     split-flux: irc = ...
 *
 * The left side names the formula to be replaced. If no method is named, the formula of
 * the first method in list order is replaced that has a formula for this symbol with
 * all the quantities used.
 */
#ifndef PP_METHODS_VARIANT_H
#define PP_METHODS_VARIANT_H

#include "methods/method.h"

struct pp_variant {
    const struct pp_method *method;
    char name[40]; /* name of the column: "bre-variant", "bre-variant-2" */
    struct pp_formula_variant formula;
};

struct pp_variant_list {
    int count;
    struct pp_variant *list;
};

/* Parses and adds one more variant. A mistake is PP_BAD_INPUT with the column, followed
 * by two lines: the text, and a caret below the mistake. */
enum pp_status pp_variant_add(struct pp_variant_list *variants, const char *text,
                              struct pp_error *err);
void pp_variant_clear(struct pp_variant_list *variants);

#endif
