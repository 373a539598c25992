#include "charts/kinds.h"

#include <string.h>

const struct pp_chart_kind pp_chart_kinds[] = {
    {"section", "daylight factor against distance from the window, over the section"},
    {"plan", "contours of the daylight factor and the no-sky line, on the plan"},
    {0, 0},
};

const struct pp_chart_kind *pp_chart_kind_find(const char *name)
{
    for (const struct pp_chart_kind *kind = pp_chart_kinds; kind->name; kind++)
        if (strcmp(kind->name, name) == 0)
            return kind;
    return 0;
}
