/* formula_option.c - collects the values of --formula, and parses them before any file
 * is read. */
#include "cli/df/formula_option.h"

#include <stdlib.h>

#include "model/base/array.h"

static enum pp_status add_text(const char *text, void *place, struct pp_error *err)
{
    struct pp_formula_words *words = place;
    enum pp_status status =
        pp_array_append(&words->list, words->count, sizeof *words->list, err);
    if (status == PP_OK)
        words->list[words->count++] = text;
    return status;
}

const struct pp_option pp_formula_option[] = {
    {"formula", 0, "FORMULA",
     "Add a column with a variant of a method's formula, such as \"irc = 0.83 W / (A "
     "(1 - R)) (C R_fw + 5 R_cw)\" or \"split-flux: irc = ...\". Repeat the option to "
     "add more. df --list-formulas shows all formulae and symbols.",
     add_text, 0},
    {0},
};

enum pp_status pp_formula_option_settle(struct pp_formula_words *words,
                                        struct pp_method_options *options,
                                        struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < words->count && status == PP_OK; i++) {
        struct pp_error own = {0};
        status = pp_variant_add(&words->variants, words->list[i], &own);
        if (status != PP_OK)
            pp_fail(err, status, "--formula, %s", own.message);
    }
    if (words->count > 0)
        options->variants = &words->variants;
    return status;
}

void pp_formula_option_clear(struct pp_formula_words *words)
{
    pp_variant_clear(&words->variants);
    free(words->list);
}
