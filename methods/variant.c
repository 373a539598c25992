/* variant.c - finds the method to which a variant belongs, and reports errors in
 * variants. */
#include "methods/variant.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

enum { TEXT_MOST = PP_EXPRESSION_MOST + 60, NAMES_MOST = 64 };

/* Fails with the text and a caret under a column (from 0). The text before the caret is
 * ASCII, since a multi-byte character would itself be a mistake. */
static enum pp_status fail_at(struct pp_error *err, const char *text, int column,
                              const char *what)
{
    char shown[TEXT_MOST + 1];
    snprintf(shown, sizeof shown, "%s", text);
    for (char *at = shown; *at; at++)
        if ((unsigned char)*at < ' ' || (unsigned char)*at > '~')
            *at = '?';
    return pp_fail(err, PP_BAD_INPUT, "column %d: %s\n  %s\n  %*s^", column + 1, what,
                   shown, column, "");
}

/* ---- the replaced formula ---- */

/* The text split into its parts; columns from 0. */
struct parts {
    const char *text;
    bool names_method;
    int method, method_length;
    int symbol, symbol_length;
    int sum;
};

static int skip_blanks(const char *text, int at)
{
    return at + (int)strspn(text + at, " ");
}

static enum pp_status take_apart(struct parts *parts, const char *text,
                                 struct pp_error *err)
{
    *parts = (struct parts){.text = text};
    if (strlen(text) > TEXT_MOST) {
        char what[64];
        snprintf(what, sizeof what,
                 "the formula is too long; expected at most %d characters", TEXT_MOST);
        return fail_at(err, text, TEXT_MOST, what);
    }
    int at = skip_blanks(text, 0);
    const char *colon = strchr(text, ':');
    if (colon) {
        int end = (int)(colon - text);
        parts->names_method = true;
        parts->method = at;
        while (end > at && text[end - 1] == ' ')
            end--;
        parts->method_length = end - at;
        at = skip_blanks(text, (int)(colon - text) + 1);
    }
    parts->symbol = at;
    parts->symbol_length = pp_expression_name_length(text + at);
    if (parts->symbol_length == 0)
        return fail_at(err, text, at, "expected the symbol of the result, such as irc");
    at = skip_blanks(text, at + parts->symbol_length);
    if (text[at] != '=')
        return fail_at(err, text, at, "expected \"=\" after the symbol");
    parts->sum = skip_blanks(text, at + 1);
    return PP_OK;
}

static enum pp_status find_method(const struct pp_method **method,
                                  const struct parts *parts, struct pp_error *err)
{
    const char *names[NAMES_MOST];
    char typed[TEXT_MOST + 1], what[512];
    int count = 0;
    snprintf(typed, sizeof typed, "%.*s", parts->method_length,
             parts->text + parts->method);
    *method = pp_method_find(typed);
    if (*method && (*method)->formulae)
        return PP_OK;
    for (int i = 0; pp_methods[i] && count < NAMES_MOST; i++)
        if (pp_methods[i]->formulae)
            names[count++] = pp_methods[i]->name;
    snprintf(what, sizeof what,
             *method ? "this method has no formulae; expected "
                     : "unknown method; expected ");
    pp_text_append_list(what, sizeof what, names, count, " or ");
    return fail_at(err, parts->text, parts->method, what);
}

/* ---- the formula ---- */

/* Mistake in a variant's text. Each formula tried gives one; the one farthest to the
 * right is kept, since it belongs to the most similar formula. */
struct misfit {
    const struct pp_method *method; /* NULL: no formula for the symbol can be
                                     * replaced */
    struct pp_expression_mistake mistake;
};

/* True if the text is a variant of this formula and its result has the formula's
 * unit. */
static bool fits_formula(const struct pp_formula *formula,
                         const struct pp_formula_variant *variant,
                         struct pp_expression_mistake *mistake)
{
    struct pp_expression expression;
    if (!pp_formula_parse(&expression, formula, variant->sum, variant->shift, mistake))
        return false;
    if (pp_formula_comes_out(formula, &expression))
        return true;
    char is[96];
    pp_dimension_describe(is, expression.dimension);
    mistake->column = variant->shift;
    snprintf(mistake->what, sizeof mistake->what,
             "the result is %s; expected the unit of %s, as in \"%s\"", is,
             formula->symbol, formula->sum);
    return false;
}

static bool fits(const struct pp_method *method,
                 const struct pp_formula_variant *variant, struct misfit *misfit)
{
    for (int i = 0; method->formulae && method->formulae[i]; i++) {
        const struct pp_formula *formula = method->formulae[i];
        struct pp_expression_mistake mistake;
        if (!pp_formula_is_open(formula, variant->symbol))
            continue;
        if (fits_formula(formula, variant, &mistake))
            return true;
        if (!misfit->method || mistake.column > misfit->mistake.column)
            *misfit = (struct misfit){method, mistake};
    }
    return false;
}

/* Fails with the symbols of the formulae of one method (NULL: of all) that can be
 * replaced. */
static enum pp_status fail_symbol(const struct parts *parts,
                                  const struct pp_method *method, struct pp_error *err)
{
    const char *symbols[NAMES_MOST];
    char what[512];
    int count = 0;
    for (int i = 0; pp_methods[i]; i++)
        for (int k = 0; pp_methods[i]->formulae && pp_methods[i]->formulae[k]; k++) {
            const struct pp_formula *formula = pp_methods[i]->formulae[k];
            bool known = !pp_formula_is_open(formula, formula->symbol)
                         || (method && method != pp_methods[i]);
            for (int n = 0; n < count; n++)
                known |= strcmp(symbols[n], formula->symbol) == 0;
            if (!known && count < NAMES_MOST)
                symbols[count++] = formula->symbol;
        }
    snprintf(what, sizeof what,
             "no formula%s%s for \"%.*s\" can be replaced; expected ",
             method ? " of " : "", method ? method->name : "", parts->symbol_length,
             parts->text + parts->symbol);
    if (count > 0)
        pp_text_append_list(what, sizeof what, symbols, count, " or ");
    else
        pp_text_append(what, sizeof what, "another method");
    return fail_at(err, parts->text, parts->symbol, what);
}

static enum pp_status find_formula(struct pp_variant *variant,
                                   const struct parts *parts, struct pp_error *err)
{
    struct misfit misfit = {0};
    const struct pp_method *named = variant->method;
    for (int i = 0; pp_methods[i]; i++)
        if ((!named || named == pp_methods[i])
            && fits(pp_methods[i], &variant->formula, &misfit)) {
            variant->method = pp_methods[i];
            return PP_OK;
        }
    if (!misfit.method)
        return fail_symbol(parts, named, err);
    char what[sizeof misfit.mistake.what + 64];
    snprintf(what, sizeof what, "%s (%s of %s)", misfit.mistake.what,
             variant->formula.symbol, misfit.method->name);
    return fail_at(err, parts->text, misfit.mistake.column, what);
}

static enum pp_status read_variant(struct pp_variant *variant, const char *text,
                                   struct pp_error *err)
{
    struct parts parts;
    struct pp_formula_variant *formula = &variant->formula;
    enum pp_status status = take_apart(&parts, text, err);
    if (status == PP_OK && parts.names_method)
        status = find_method(&variant->method, &parts, err);
    if (status != PP_OK)
        return status;
    if (parts.symbol_length >= (int)sizeof formula->symbol)
        return fail_symbol(&parts, variant->method, err);
    if (strlen(text + parts.sum) > PP_EXPRESSION_MOST)
        return fail_at(err, text, parts.sum + PP_EXPRESSION_MOST,
                       "the formula is too long; expected at most 200 characters");
    snprintf(formula->symbol, sizeof formula->symbol, "%.*s", parts.symbol_length,
             text + parts.symbol);
    snprintf(formula->sum, sizeof formula->sum, "%s", text + parts.sum);
    formula->shift = parts.sum;
    return find_formula(variant, &parts, err);
}

enum pp_status pp_variant_add(struct pp_variant_list *variants, const char *text,
                              struct pp_error *err)
{
    struct pp_variant variant = {0};
    enum pp_status status = read_variant(&variant, text, err);
    if (status != PP_OK)
        return status;
    int before = 0;
    for (int i = 0; i < variants->count; i++)
        before += variants->list[i].method == variant.method;
    snprintf(variant.name, sizeof variant.name, "%s-variant", variant.method->name);
    if (before > 0)
        pp_text_append(variant.name, sizeof variant.name, "-%d", before + 1);
    status = pp_array_append(&variants->list, variants->count, sizeof variant, err);
    if (status == PP_OK)
        variants->list[variants->count++] = variant;
    return status;
}

void pp_variant_clear(struct pp_variant_list *variants)
{
    free(variants->list);
    *variants = (struct pp_variant_list){0};
}
