/* section_outside.h - obstructions outside a section: the building opposite, and lines
 * of sight with their angles. */
#ifndef PP_CHARTS_SECTION_SECTION_OUTSIDE_H
#define PP_CHARTS_SECTION_SECTION_OUTSIDE_H

#include "charts/section/section_frame.h"

/* Draws the line of sight from the window at the near or far end, with the horizontal
 * line and the angle between them. An obstruction too far away for the drawing is
 * placed where the line of sight ends, behind a break in the horizontal line. The
 * height of the obstruction is then not to scale, but the angle is correct. Below an
 * overhang a dashed line shows the upper limit of the visible sky. */
void pp_section_outside_draw(cairo_t *cr, const struct pp_style *style,
                             const struct pp_room_section *section, bool near);

/* Appends a sentence on distance and height of the obstruction at that end, for
 * sections without lines of sight. Appends nothing if there is no obstruction or its
 * distance is infinite. */
void pp_section_outside_say(char *text, size_t room,
                            const struct pp_room_section *section, bool near);

#endif
