/* site_names.h - names on a site plan: of rooms, buildings, gardens, and of windows
 * whose values are in a table. A name is placed at the free place nearest to the middle
 * of its object, or else omitted. */
#ifndef PP_CHARTS_SITE_SITE_NAMES_H
#define PP_CHARTS_SITE_SITE_NAMES_H

#include "charts/site/site_drawing.h"

/* Box of the drawing on paper (mm). */
struct pp_box pp_site_names_frame(const struct pp_room_plan *frame);

/* Depth of a window's strip on paper, and the distance of the strip from the wall
 * (mm). */
double pp_site_names_deep(const struct pp_style *style);
double pp_site_names_near(const struct pp_style *style, int storey);

/* Writes the names of windows that do not fit into their strips in front of them, the
 * lowest storey first. */
void pp_site_names_windows(struct pp_site_drawing *drawing);

/* Writes all other names. Call after everything else is drawn and registered. */
void pp_site_names_draw(struct pp_site_drawing *drawing);

#endif
