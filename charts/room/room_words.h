/* room_words.h - the given data of a room in words: its size, an opening, obstructions.
 * Texts are appended as by pp_page_say. */
#ifndef PP_CHARTS_ROOM_ROOM_WORDS_H
#define PP_CHARTS_ROOM_ROOM_WORDS_H

#include <stddef.h>

#include "model/room/world.h"

/* Extent and area of the floor, height, height of the working plane. */
void pp_room_words_size(char *text, size_t room, const struct pp_world *world);

/* Size, sill, glass and allowances of an opening. */
void pp_room_words_opening(char *text, size_t room, const struct pp_world *world,
                           int opening);

/* Skylines and blocks, which may be outside the drawings. */
void pp_room_words_outside(char *text, size_t room, const struct pp_world *world);

#endif
