/* steps.c - see steps.h. */
#include "model/results/steps.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"
#include "model/geometry/vec.h"

double pp_steps_printed_unit(enum pp_step_unit unit)
{
    return unit == PP_UNIT_DAYLIGHT_FACTOR ? 100.0
           : unit == PP_UNIT_ANGLE         ? 1.0 / PP_RAD
                                           : 1.0;
}

/* Appends a step to the list. Returns NULL if there is no list or memory runs out. */
static struct pp_calculation_step *next(struct pp_steps *steps)
{
    if (!steps)
        return NULL;
    if (pp_array_reserve(&steps->list, &steps->capacity, steps->count + 1,
                         sizeof *steps->list, NULL)
        != PP_OK) {
        steps->failed = true;
        return NULL;
    }
    struct pp_calculation_step *step = &steps->list[steps->count++];
    *step = (struct pp_calculation_step){.line = steps->line};
    return step;
}

void pp_steps_add_v(struct pp_steps *steps, enum pp_step_unit unit, double value,
                    const char *symbol, const char *formula, const char *what,
                    va_list args)
{
    struct pp_calculation_step *step = next(steps);
    if (!step)
        return;
    step->unit = unit;
    step->value = value;
    snprintf(step->symbol, sizeof step->symbol, "%s", symbol);
    snprintf(step->formula, sizeof step->formula, "%s", formula);
    vsnprintf(step->what, sizeof step->what, what, args);
}

void pp_steps_add_named(struct pp_steps *steps, enum pp_step_unit unit, double value,
                        const char *symbol, const char *what, ...)
{
    va_list args;
    va_start(args, what);
    pp_steps_add_v(steps, unit, value, symbol, "", what, args);
    va_end(args);
}

void pp_steps_add_worked(struct pp_steps *steps, enum pp_step_unit unit, double value,
                         const char *symbol, const char *formula, const char *what, ...)
{
    va_list args;
    va_start(args, what);
    pp_steps_add_v(steps, unit, value, symbol, formula, what, args);
    va_end(args);
}

/* A sum too long for one line becomes several steps; each continues from the previous
 * one. */
void pp_steps_add_sum(struct pp_steps *steps, int first, int count, const char *symbol,
                      const char *what)
{
    enum { LINE_MOST = 160, LONGEST_TERM = 32 };
    if (!steps)
        return;
    char formula[LINE_MOST] = "";
    double sum = 0.0;
    for (int i = 1; i <= count; i++) {
        char name[32];
        snprintf(name, sizeof name, "%s_%d", symbol, i);
        const struct pp_calculation_step *term = pp_steps_find(steps, first, name);
        if (!term)
            continue;
        if (sizeof formula - strlen(formula) <= LONGEST_TERM) {
            pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, sum, symbol, formula,
                                "%s, so far", what);
            snprintf(formula, sizeof formula, "%s", symbol);
            term = pp_steps_find(steps, first, name);
        }
        pp_text_append(formula, sizeof formula, "%s%s", formula[0] ? " + " : "", name);
        sum += term->value;
    }
    pp_steps_add_worked(steps, PP_UNIT_DAYLIGHT_FACTOR, sum, symbol,
                        formula[0] ? formula : "0", "%s", what);
}

const struct pp_calculation_step *pp_steps_find(const struct pp_steps *steps, int first,
                                                const char *symbol)
{
    for (int i = steps->count - 1; i >= first; i--)
        if (strcmp(steps->list[i].symbol, symbol) == 0)
            return &steps->list[i];
    return NULL;
}

void pp_steps_clear(struct pp_steps *steps)
{
    free(steps->list);
    *steps = (struct pp_steps){0};
}
