/* lists.c - implementation of pepperpot.h: lists by name, and the version. */
#include <stdio.h>
#include <stdlib.h>

#include "api/chart_kind.h"
#include "methods/method.h"
#include "pepperpot.h"
#include "studies/criteria/criteria.h"
#include "studies/engines/engine.h"

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)

int pp_version(void)
{
    return PP_VERSION_NUMBER;
}

const char *pp_version_text(void)
{
    return TEXT(PP_VERSION_MAJOR) "." TEXT(PP_VERSION_MINOR) "." TEXT(PP_VERSION_MICRO);
}

void pp_free(void *bytes)
{
    free(bytes);
}

/* Name and summary of an entry of a list; both NULL past the end. */
struct list_entry {
    const char *name, *summary;
};

static struct list_entry entry_of(enum pp_list list, int index)
{
    const struct pp_method *method;
    const struct pp_engine *engine;
    const struct pp_chart_kind *chart;
    const struct pp_criterion *criterion;
    switch (list) {
    case PP_LIST_METHODS:
        method = pp_method_at(index);
        return method ? (struct list_entry){method->name, method->summary}
                      : (struct list_entry){0};
    case PP_LIST_ENGINES:
        engine = pp_engine_at(index);
        return engine ? (struct list_entry){engine->name, engine->summary}
                      : (struct list_entry){0};
    case PP_LIST_CHARTS:
        chart = pp_chart_kind_at(index);
        return chart ? (struct list_entry){chart->name, chart->summary}
                     : (struct list_entry){0};
    case PP_LIST_CRITERIA:
        criterion = pp_criteria_at(index);
        return criterion ? (struct list_entry){criterion->name, criterion->summary}
                         : (struct list_entry){0};
    }
    return (struct list_entry){0};
}

const char *pp_list_name(enum pp_list list, int index)
{
    return index < 0 ? NULL : entry_of(list, index).name;
}

const char *pp_list_summary(enum pp_list list, int index)
{
    return index < 0 ? NULL : entry_of(list, index).summary;
}
