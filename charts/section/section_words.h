/* section_words.h - names and dimensions in a section: name and height of the room, the
 * length between its walls, and the names of walls and openings. */
#ifndef PP_CHARTS_SECTION_SECTION_WORDS_H
#define PP_CHARTS_SECTION_SECTION_WORDS_H

#include "charts/section/section_frame.h"

/* Height of the strip of dimensions below the floor, mm. */
double pp_section_words_mm(const struct pp_style *style);

void pp_section_words_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_room_section *section);

#endif
