/* glazings.c - see glazings.h. */
#include "model/light/glazings.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static const struct pp_glazing glazings[] = {
#include "tables/glazings.inc"
};

int pp_glazings_count(void)
{
    return sizeof glazings / sizeof *glazings;
}

const struct pp_glazing *pp_glazings_at(int index)
{
    return &glazings[index];
}

const struct pp_glazing *pp_glazings_find(const char *name)
{
    for (int i = 0; i < pp_glazings_count(); i++)
        if (strcmp(glazings[i].name, name) == 0)
            return &glazings[i];
    return NULL;
}

struct pp_glass pp_glazings_glass(const struct pp_glazing *glazing)
{
    int panes = (int)glazing->panes;
    if (strcmp(glazing->diffusing, "yes") == 0)
        return pp_glass_diffusing(glazing->normal);
    if (isnan(glazing->normal))
        return pp_glass_panes(panes, glazing->n, glazing->kl);
    return pp_glass_of_normal(panes, glazing->n, glazing->kl, glazing->normal);
}
