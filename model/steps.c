/* steps.c - see steps.h. */
#include "model/steps.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* One more step at the end of the list; NULL where there is no list or no memory. */
static struct pp_step *next(struct pp_steps *steps)
{
    if (!steps)
        return NULL;
    if (steps->count == steps->capacity) {
        int capacity = steps->capacity ? 2 * steps->capacity : 16;
        struct pp_step *list = realloc(steps->list, (size_t)capacity * sizeof *list);
        if (!list) {
            steps->failed = true;
            return NULL;
        }
        steps->list = list;
        steps->capacity = capacity;
    }
    struct pp_step *step = &steps->list[steps->count++];
    *step = (struct pp_step){0};
    return step;
}

static void fill(struct pp_steps *steps, enum pp_unit unit, double value,
                 const char *symbol, const char *formula, const char *what,
                 va_list args)
{
    struct pp_step *step = next(steps);
    if (!step)
        return;
    step->unit = unit;
    step->value = value;
    snprintf(step->symbol, sizeof step->symbol, "%s", symbol);
    snprintf(step->formula, sizeof step->formula, "%s", formula);
    vsnprintf(step->what, sizeof step->what, what, args);
}

void pp_step(struct pp_steps *steps, enum pp_unit unit, double value, const char *what,
             ...)
{
    va_list args;
    va_start(args, what);
    fill(steps, unit, value, "", "", what, args);
    va_end(args);
}

void pp_step_named(struct pp_steps *steps, enum pp_unit unit, double value,
                   const char *symbol, const char *what, ...)
{
    va_list args;
    va_start(args, what);
    fill(steps, unit, value, symbol, "", what, args);
    va_end(args);
}

void pp_step_worked(struct pp_steps *steps, enum pp_unit unit, double value,
                    const char *symbol, const char *formula, const char *what, ...)
{
    va_list args;
    va_start(args, what);
    fill(steps, unit, value, symbol, formula, what, args);
    va_end(args);
}

void pp_steps_clear(struct pp_steps *steps)
{
    free(steps->list);
    *steps = (struct pp_steps){0};
}
