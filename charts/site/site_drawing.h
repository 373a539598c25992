/* site_drawing.h - state of a site plan while it is drawn: shared by its layout and
 * strips (site_chart.c), its names (site_names.c) and its table (strip_table.c). */
#ifndef PP_CHARTS_SITE_SITE_DRAWING_H
#define PP_CHARTS_SITE_SITE_DRAWING_H

#include "charts/room/room_plan.h"
#include "charts/sheet/labels.h"
#include "model/results/sheets/site_sheet.h"

struct pp_site_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_site_sheet *sheet;
    struct pp_room_plan frame; /* of the site's x and y */
    struct pp_labels *labels;
    bool names_before; /* names of windows stand in front of their strips */
    bool on_next;      /* the table is too large for this sheet */
    bool in_table;     /* figures of windows are in a table, their names on the plan */
};

#endif
