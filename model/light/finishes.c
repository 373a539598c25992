/* finishes.c - see finishes.h. */
#include "model/light/finishes.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static const struct pp_finish finishes[] = {
#include "tables/finishes.inc"
};

int pp_finishes_count(void)
{
    return sizeof finishes / sizeof *finishes;
}

const struct pp_finish *pp_finishes_at(int index)
{
    return &finishes[index];
}

const struct pp_finish *pp_finishes_find(const char *name)
{
    for (int i = 0; i < pp_finishes_count(); i++)
        if (strcmp(finishes[i].name, name) == 0)
            return &finishes[i];
    return NULL;
}
