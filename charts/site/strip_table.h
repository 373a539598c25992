/* strip_table.h - table of the windows of a site plan: name, room, and existing and
 * proposed vertical sky component. */
#ifndef PP_CHARTS_SITE_STRIP_TABLE_H
#define PP_CHARTS_SITE_STRIP_TABLE_H

#include "charts/site/site_drawing.h"

/* Size of the table (mm) if it is at most `height` mm high, with as many columns of
 * windows as necessary. */
struct pp_box pp_strip_table_size(const struct pp_site_drawing *drawing, double height);

/* Draws the table from the upper left corner of the box. Its columns are as high as the
 * box. */
void pp_strip_table_draw(const struct pp_site_drawing *drawing, struct pp_box box);

#endif
