/* room_words.h - the given data of a room in words: its size, an opening, obstructions.
 * The functions append text as pp_page_say does. */
#ifndef PP_CHARTS_ROOM_ROOM_WORDS_H
#define PP_CHARTS_ROOM_ROOM_WORDS_H

#include <stddef.h>

#include "model/room/world.h"

/* Appends extent and area of the floor, height of the room, and height of the working
 * plane. */
void pp_room_words_size(char *text, size_t room, const struct pp_world *world);

/* Appends size, sill, glass and allowances of an opening. */
void pp_room_words_opening(char *text, size_t room, const struct pp_world *world,
                           int opening);

/* Appends the skylines, blocks and trees, which may be outside the drawings. */
void pp_room_words_outside(char *text, size_t room, const struct pp_world *world);

#endif
