/* room_section.h - vertical section of the room, drawn to scale: floor, walls,
 * openings, working plane with its receivers, and obstructions outside. */
#ifndef PP_CHARTS_SECTION_ROOM_SECTION_H
#define PP_CHARTS_SECTION_ROOM_SECTION_H

#include "charts/section/section_frame.h"

/* True if the window at the near or far end has an obstruction outside. */
bool pp_room_section_has_outside(const struct pp_room_section *section, bool near);

/* Sets the largest usual scale, within least_scale, at which the section and its
 * caption fit into a width of length_mm and a height of height_mm. */
void pp_room_section_fit(struct pp_room_section *section, const struct pp_style *style,
                         double length_mm, double height_mm);

void pp_room_section_draw(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_section *section);

#endif
