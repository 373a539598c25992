/* site_drawing.h - drawing state of a site plan, shared by site_chart.c (layout and
 * strips), site_names.c and strip_table.c. */
#ifndef PP_CHARTS_SITE_SITE_DRAWING_H
#define PP_CHARTS_SITE_SITE_DRAWING_H

#include "charts/room/room_plan.h"
#include "charts/sheet/labels.h"
#include "model/results/sheets/site_sheet.h"

struct pp_site_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_site_sheet *sheet;
    struct pp_room_plan frame; /* frame for x and y of the site */
    struct pp_labels *labels;
    bool names_before; /* names of windows are in front of their strips */
    bool on_next;      /* the table is too large for this sheet, and follows on the
                        * next */
    bool in_table;     /* values of windows are in a table, and their names on the
                        * plan */
};

#endif
