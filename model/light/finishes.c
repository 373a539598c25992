/* finishes.c - see finishes.h. */
#include "model/light/finishes.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static const struct pp_finish finishes[] = {
#include "tables/finishes.inc"
};

int pp_finish_count(void)
{
    return sizeof finishes / sizeof *finishes;
}

const struct pp_finish *pp_finish_at(int index)
{
    return &finishes[index];
}

const struct pp_finish *pp_finish_find(const char *name)
{
    for (int i = 0; i < pp_finish_count(); i++)
        if (strcmp(finishes[i].name, name) == 0)
            return &finishes[i];
    return NULL;
}
