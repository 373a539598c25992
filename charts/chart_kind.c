/* chart_kind.c - the list of charts, in the order in which it is printed. */
#include "charts/chart_kind.h"

#include <string.h>

static const struct pp_chart_kind kinds[] = {
    {"section", "daylight factor against distance, over the section", .board = false},
    {"plan", "daylight factor contours and no-sky line, on the plan", .board = false},
    {"waldram", "Waldram diagram, blank or with a room's windows", .board = true,
     .from_point = true},
    {"pepper-pot", "pepper-pot diagram, blank or with a room's windows", .board = true,
     .from_point = true},
    {"protractor",
     "BRS daylight protractor, blank or laid on a room's section and plan",
     .board = true, .from_point = true},
    {"nomogram",
     "nomogram of the internally reflected component, blank or with a room's lines",
     .board = true},
    {"availability",
     "how often the sky gives how much light in working hours, and inside",
     .outside = true},
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
