/* doubts.h - input that is valid but probably not meant: warnings. */
#ifndef PP_STUDIES_DOUBTS_H
#define PP_STUDIES_DOUBTS_H

#include "model/base/mistakes.h"
#include "model/room/world.h"

/* Beyond these a length is probably in another unit (m). */
#define PP_DOUBTS_ROOM_MOST_M 500.0
#define PP_DOUBTS_ROOM_HEIGHT_MOST_M 100.0
#define PP_DOUBTS_ROOM_LEAST_M 0.5
#define PP_DOUBTS_OUTSIDE_HEIGHT_MOST_M 1000.0

/* Below this a frame factor or maintenance is probably a loss: the lowest published
 * maintenance is 0.5 [BRE309]. */
#define PP_DOUBTS_FACTOR_LEAST 0.4

/* A material that loses more of diffuse light by its roughness is too steep for its model
 * (rough_surface.h). */
#define PP_DOUBTS_LOST_MOST 0.2

/* Adds a warning, with the line of the room file (0: the file as a whole), for
 *
 * - a room, block or mesh whose size suggests another unit;
 * - a frame factor or maintenance that looks like a loss;
 * - the data of a measured pane (bsdf.h);
 * - a physically rough material with too steep slopes;
 * - latitude and longitude that lie near the site's country when swapped, and far from it
 *   as given;
 * - in a file of one room (alone): no opening, a block away from the room that lies behind
 *   all its openings, and a far skyline before a wall without an opening. */
void pp_doubts_find(struct pp_mistakes *doubts, const struct pp_world *world,
                    bool alone);

#endif
