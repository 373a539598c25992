/* shades.h - the step that adds the shades of windows: overhangs, fins, balconies and
 * light shelves. Inside model/room/ only.
 *
 * Each is one opaque polygon or a few, without thickness, which begin in the plane of
 * the wall's outside: the facade's, else that of the glass. Lengths are counted from
 * the window's edges, left and right as drawn from outside:
 *
 *   overhang  level, `above` the head, `depth` deep, beyond the jambs by left and right
 *   fin       upright, `gap` beside a jamb, from `below` the sill to `above` the head
 *   balcony   a floor at the level of the room's, or `level` above it, and a parapet
 *             round it
 *   shelf     level, `height` above the sill, `depth` outside and `inside` the wall
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_SHADES_H
#define PP_MODEL_ROOM_OUTSIDE_SHADES_H

#include "model/room/build/resolve.h"

/* Adds the shades after the free-standing surfaces, which keep the order of the file.
 * Reports shades of windows in sloping walls, shades that cross the room, and shelves
 * above the head. */
enum pp_status pp_build_shades(struct pp_resolver *r, struct pp_error *err);

/* Name of the opening's shade in that line, "balcony"; static; NULL: there is none. */
const char *pp_shades_word(const struct pp_opening_part *part, int line);

#endif
