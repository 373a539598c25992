/* formula_option.h - the option --formula: a user's variants of published formulae. */
#ifndef PP_CLI_DF_FORMULA_OPTION_H
#define PP_CLI_DF_FORMULA_OPTION_H

#include "cli/options.h"
#include "methods/variant.h"

struct pp_formula_words {
    const char **list; /* variants as typed; strings of argv, not owned */
    int count;
    struct pp_variant_list variants;
};

/* Option list for struct pp_option_group; the values are stored in a struct
 * pp_formula_words. */
extern const struct pp_option pp_formula_option[];

/* Parses the variants, if any, and makes `options` point to them. */
enum pp_status pp_formula_option_settle(struct pp_formula_words *words,
                                        struct pp_method_options *options,
                                        struct pp_error *err);
void pp_formula_option_clear(struct pp_formula_words *words);

#endif
