/* section_words.h - names and dimensions of a section: the room and its height, its
 * length between the walls with their names, and the openings. */
#ifndef PP_CHARTS_SECTION_SECTION_WORDS_H
#define PP_CHARTS_SECTION_SECTION_WORDS_H

#include "charts/section/section_frame.h"

/* Height of the strip of dimensions below the floor, mm. */
double pp_section_words_mm(const struct pp_style *style);

void pp_section_words_draw(cairo_t *cr, const struct pp_style *style,
                           const struct pp_room_section *section);

#endif
