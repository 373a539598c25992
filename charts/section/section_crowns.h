/* section_crowns.h - crowns of trees that the section cuts. */
#ifndef PP_CHARTS_SECTION_SECTION_CROWNS_H
#define PP_CHARTS_SECTION_SECTION_CROWNS_H

#include "charts/section/section_frame.h"

/* Draws each cut crown as a grey rectangle. */
void pp_section_crowns_draw(cairo_t *cr, const struct pp_style *style,
                            const struct pp_room_section *section);

/* True if the section cuts a crown outside its near or far end. */
bool pp_section_crowns_are_outside(const struct pp_section_cut *cut,
                                   const struct pp_world *world, bool near);

#endif
