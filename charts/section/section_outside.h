/* section_outside.h - obstructions outside a section: lines of sight with their angles,
 * and the building opposite. */
#ifndef PP_CHARTS_SECTION_SECTION_OUTSIDE_H
#define PP_CHARTS_SECTION_SECTION_OUTSIDE_H

#include "charts/section/section_frame.h"

/* Draws the line of sight out of the window at the near or far end, with the horizontal
 * and the angle between them. An obstruction too far for the drawing is put where the
 * line of sight ends, behind a break in the horizontal: heights are then not to scale,
 * but angles are correct. Below an overhang a dashed line shows the upper limit of the
 * visible sky. */
void pp_section_outside_draw(cairo_t *cr, const struct pp_style *style,
                             const struct pp_room_section *section, bool near);

/* Adds a sentence on distance and height of the obstruction at that end, for sections
 * without lines of sight; nothing if there is none. */
void pp_section_outside_say(char *text, size_t room,
                            const struct pp_room_section *section, bool near);

#endif
