/* formula.c - parses formulae and stores them for a method. */
#include "model/results/formula.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { QUANTITIES_MOST = 40 };

/* Powers of metre, degree and per cent, by unit. */
static const struct pp_dimension dimensions[] = {
    [PP_UNIT_DAYLIGHT_FACTOR] = {.per_cent = 1.0},
    [PP_UNIT_NUMBER] = {0},
    [PP_UNIT_COUNT] = {0},
    [PP_UNIT_ANGLE] = {.degrees = 1.0},
    [PP_UNIT_METRE] = {.metres = 1.0},
    [PP_UNIT_SQUARE_METRE] = {.metres = 2.0},
    [PP_UNIT_LUX] = {0},
};

bool pp_formula_is_open(const struct pp_formula *formula, const char *symbol)
{
    return !formula->fixed && formula->symbol[0]
           && strcmp(formula->symbol, symbol) == 0;
}

bool pp_formula_comes_out(const struct pp_formula *formula,
                          const struct pp_expression *expression)
{
    return fabs(dimensions[formula->unit].metres - expression->dimension.metres) < 1e-9;
}

bool pp_formula_parse(struct pp_expression *expression,
                      const struct pp_formula *formula, const char *sum, int shift,
                      struct pp_expression_mistake *mistake)
{
    struct pp_expression_name names[QUANTITIES_MOST];
    int count = 0;
    for (; formula->quantities[count].symbol; count++) {
        assert(count < QUANTITIES_MOST);
        names[count] =
            (struct pp_expression_name){formula->quantities[count].symbol,
                                        dimensions[formula->quantities[count].unit]};
    }
    return pp_expression_parse(expression, sum, shift, names, count, mistake);
}

/* Parses a published sum; it cannot fail, since tests parse all of them. */
static void parse_published(struct pp_expression *expression,
                            const struct pp_formula *formula)
{
    struct pp_expression_mistake mistake;
    bool good = pp_formula_parse(expression, formula, formula->sum, 0, &mistake);
    assert(good);
    (void)good;
}

double pp_formula_value(const struct pp_formula *formula, const double *values)
{
    struct pp_expression expression;
    double printed[QUANTITIES_MOST];
    parse_published(&expression, formula);
    for (int i = 0; formula->quantities[i].symbol; i++)
        printed[i] = values[i] * pp_steps_printed_unit(formula->quantities[i].unit);
    return pp_expression_value(&expression, printed, NULL)
           / pp_steps_printed_unit(formula->unit);
}

/* ---- the formulae of a method ---- */

struct entry {
    const struct pp_formula *formula;
    const char *sum; /* not owned */
    bool own;
    struct pp_expression expression;
};

struct pp_formulary {
    int count;
    struct entry list[];
};

enum pp_status pp_formulary_create(struct pp_formulary **formulary,
                                   const struct pp_formula *const *formulae,
                                   const struct pp_formula_variant *variant,
                                   struct pp_error *err)
{
    size_t count = 0;
    while (formulae && formulae[count])
        count++;
    *formulary = malloc(sizeof **formulary + (count + 1) * sizeof(struct entry));
    if (!*formulary)
        return pp_fail_memory(err);
    (*formulary)->count = (int)count;
    for (size_t i = 0; i < count; i++) {
        struct entry *entry = &(*formulary)->list[i];
        struct pp_expression_mistake mistake;
        entry->formula = formulae[i];
        entry->own = variant && pp_formula_is_open(formulae[i], variant->symbol)
                     && pp_formula_parse(&entry->expression, formulae[i], variant->sum,
                                         variant->shift, &mistake)
                     && pp_formula_comes_out(formulae[i], &entry->expression);
        entry->sum = entry->own ? variant->sum : formulae[i]->sum;
        if (!entry->own)
            parse_published(&entry->expression, formulae[i]);
    }
    return PP_OK;
}

void pp_formulary_destroy(struct pp_formulary *formulary)
{
    free(formulary);
}

const struct pp_expression *pp_formulary_find(const struct pp_formulary *formulary,
                                              const struct pp_formula *formula,
                                              struct pp_expression *spare,
                                              const char **sum, bool *own)
{
    for (int i = 0; formulary && i < formulary->count; i++) {
        const struct entry *entry = &formulary->list[i];
        if (entry->formula != formula)
            continue;
        *sum = entry->sum;
        *own = entry->own;
        return &entry->expression;
    }
    *sum = formula->sum;
    *own = false;
    parse_published(spare, formula);
    return spare;
}
