/* site_names.h - names on a site plan: of rooms, buildings, gardens, and of windows whose
 * figures are in a table. A name is put at the free place nearest to the middle of its
 * object, or else left out. */
#ifndef PP_CHARTS_SITE_SITE_NAMES_H
#define PP_CHARTS_SITE_SITE_NAMES_H

#include "charts/site/site_drawing.h"

/* Box of the drawing on paper. */
struct pp_box pp_site_names_frame(const struct pp_room_plan *frame);

/* Depth on paper of a window's strip, and its distance from the wall. */
double pp_site_names_deep(const struct pp_style *style);
double pp_site_names_near(const struct pp_style *style, int storey);

/* Writes names of windows in front of their strips, the lowest storey first, where they
 * do not fit into the strips. */
void pp_site_names_windows(struct pp_site_drawing *drawing);

/* Writes all other names; to be called after everything else is drawn and
 * registered. */
void pp_site_names_draw(struct pp_site_drawing *drawing);

#endif
