/* chart_kind.h - the charts there are, in one list, for the command line and the manual. */
#ifndef PP_CHARTS_CHART_KIND_H
#define PP_CHARTS_CHART_KIND_H

#include <stdbool.h>

struct pp_chart_kind {
    const char *name;    /* as typed on the command line */
    const char *summary; /* one line, without a full stop */
    bool board;          /* worked at the drawing board: can be blank, without a room */
    bool from_point;     /* and is drawn from one point of a room */
    bool outside;        /* of the light outside: can do without a room */
};

/* In order; NULL at the end of the list, one past the last. */
const struct pp_chart_kind *pp_chart_kind_at(int index);

/* The kind of that name, or NULL. */
const struct pp_chart_kind *pp_chart_kind_find(const char *name);

#endif
