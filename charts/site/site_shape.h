/* site_shape.h - draws an object on a site plan: existing objects that cover ground are
 * filled, new ones hatched, demolished ones dashed. */
#ifndef PP_CHARTS_SITE_SITE_SHAPE_H
#define PP_CHARTS_SITE_SITE_SHAPE_H

#include "charts/room/room_plan.h"
#include "model/results/sheets/site_sheet.h"

/* Draws a shape. frame: plan of the site's x and y; within: box on paper that limits
 * the hatching. */
void pp_site_shape_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *frame, struct pp_box within,
                        const struct pp_site_shape *shape);

#endif
