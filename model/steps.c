/* steps.c - see steps.h. */
#include "model/steps.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void pp_step(struct pp_steps *steps, enum pp_unit unit, double value, const char *what,
             ...)
{
    if (!steps)
        return;
    if (steps->count == steps->capacity) {
        int capacity = steps->capacity ? 2 * steps->capacity : 16;
        struct pp_step *list = realloc(steps->list, capacity * sizeof *list);
        if (!list) {
            steps->failed = true;
            return;
        }
        steps->list = list;
        steps->capacity = capacity;
    }
    struct pp_step *step = &steps->list[steps->count++];
    step->value = value;
    step->unit = unit;
    va_list args;
    va_start(args, what);
    vsnprintf(step->what, sizeof step->what, what, args);
    va_end(args);
}

void pp_steps_clear(struct pp_steps *steps)
{
    free(steps->list);
    *steps = (struct pp_steps){0};
}
