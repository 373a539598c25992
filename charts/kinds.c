#include "charts/kinds.h"

#include <string.h>

static const struct pp_chart_kind kinds[] = {
    {"section", "daylight factor against distance, over the section", false, false},
    {"plan", "daylight factor contours and no-sky line, on the plan", false, false},
    {"waldram", "Waldram diagram, blank or with a room's windows", true, false},
    {"pepper-pot", "pepper-pot diagram, blank or with a room's windows", true, false},
    {"protractor",
     "BRS daylight protractor, blank or laid on a room's section and plan", true,
     false},
    {"availability",
     "how often the sky gives how much light in working hours, and inside", false,
     true},
};

enum { KINDS = sizeof kinds / sizeof kinds[0] };

const struct pp_chart_kind *pp_chart_kind_at(int index)
{
    return index < KINDS ? &kinds[index] : 0;
}

const struct pp_chart_kind *pp_chart_kind_find(const char *name)
{
    for (int i = 0; i < KINDS; i++)
        if (strcmp(kinds[i].name, name) == 0)
            return &kinds[i];
    return 0;
}
