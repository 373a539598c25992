/* page.h - what every chart's sheet has round its drawing: title and notes.
 */
#ifndef PP_CHARTS_PAGE_H
#define PP_CHARTS_PAGE_H

#include "charts/canvas.h"
#include "charts/style.h"
#include "charts/text.h"

struct pp_page {
    const char *title;    /* the room's name; may be long; NULL: no line for it */
    const char *subtitle; /* what the chart shows, under which sky */
    const char *foot;     /* notes, one paragraph; NULL or "": none */
};

/* Draws title and notes and returns what is left of the sheet between them. */
struct pp_box pp_page_draw(struct pp_canvas *canvas, const struct pp_style *style,
                           const struct pp_page *page);

/* The style for the canvas' sheet. */
struct pp_style pp_page_style(const struct pp_canvas *canvas);

#endif
