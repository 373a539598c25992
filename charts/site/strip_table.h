/* strip_table.h - table of the windows of a site plan: name, room, and vertical sky
 * component, existing and proposed. */
#ifndef PP_CHARTS_SITE_STRIP_TABLE_H
#define PP_CHARTS_SITE_STRIP_TABLE_H

#include "charts/site/site_drawing.h"

/* Size of the table if it is no higher than `height` mm: as many columns of windows as
 * that needs. */
struct pp_box pp_strip_table_size(const struct pp_site_drawing *drawing, double height);

/* Draws the table from the upper left corner of the box, in columns as high as the
 * box. */
void pp_strip_table_draw(const struct pp_site_drawing *drawing, struct pp_box box);

#endif
