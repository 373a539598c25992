/* engine.c - the list of engines, one line each. */
#include "studies/engines/engine.h"

#include <string.h>

static const struct pp_engine *const engines[] = {
    &pp_engine_path,      &pp_engine_cache, &pp_engine_photons,
    &pp_engine_radiosity, &pp_engine_plain, NULL,
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

const struct pp_engine *pp_engine_of_column(const char *column)
{
    for (int i = 0; engines[i]; i++)
        if (strcmp(engines[i]->column, column) == 0)
            return engines[i];
    return NULL;
}

const struct pp_column *pp_engine_truth(const struct pp_report *report)
{
    const struct pp_column *truth = NULL;
    for (int i = 0; engines[i] && !truth; i++)
        if (engines[i]->is_truth)
            truth = pp_report_find(report, PP_DF, engines[i]->column);
    return truth;
}
