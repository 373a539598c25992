/* engine.c - the list of engines: a line each. */
#include "studies/engines/engine.h"

#include <string.h>

static const struct pp_engine *const engines[] = {
    &pp_engine_path,
    &pp_engine_cache,
    &pp_engine_photons,
    NULL,
};

const struct pp_engine *pp_engine_at(int index)
{
    return engines[index];
}

const struct pp_engine *pp_engine_find(const char *name)
{
    for (int i = 0; engines[i]; i++)
        if (strcmp(engines[i]->name, name) == 0)
            return engines[i];
    return NULL;
}
