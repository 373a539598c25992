/* shades.h - the step that adds the shades of windows: overhangs, fins, balconies and
 * light shelves. Inside model/room/ only.
 *
 * A shade is one or more opaque polygons without thickness. They begin in the outer
 * plane of the wall: the plane of the facade, or else of the glass. Lengths are
 * measured from the window's edges, left and right as seen from outside:
 *
 *   overhang  horizontal, `above` the head, `depth` deep, extended beyond the jambs by
 *             left and right
 *   fin       vertical, `gap` beside a jamb, from `below` the sill to `above` the head
 *   balcony   a floor at the room's floor level, or `level` above it, and a parapet
 *   shelf     horizontal, `height` above the sill, `depth` outside, `inside` the wall
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_SHADES_H
#define PP_MODEL_ROOM_OUTSIDE_SHADES_H

#include "model/room/build/resolve.h"

/* Adds the shades. Comes after the free-standing surfaces, which must keep the order of
 * the file. Reports shades of windows in sloping walls, shades that cross the room, and
 * shelves above the head. */
enum pp_status pp_build_shades(struct pp_resolver *r, struct pp_error *err);

/* Kind of the opening's shade on that line, "balcony"; static; NULL if there is
 * none. */
const char *pp_shades_word(const struct pp_opening_part *part, int line);

#endif
