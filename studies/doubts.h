/* doubts.h - warnings about input that is valid but probably not intended. */
#ifndef PP_STUDIES_DOUBTS_H
#define PP_STUDIES_DOUBTS_H

#include "model/base/mistakes.h"
#include "model/room/world.h"

/* A length beyond these limits is probably in another unit (m). */
#define PP_DOUBTS_ROOM_MOST_M 500.0
#define PP_DOUBTS_ROOM_HEIGHT_MOST_M 100.0
#define PP_DOUBTS_ROOM_LEAST_M 0.5
#define PP_DOUBTS_OUTSIDE_HEIGHT_MOST_M 1000.0

/* A frame factor or maintenance factor below this is probably a loss. The lowest
 * published maintenance factor is 0.5 [BRE309]. */
#define PP_DOUBTS_FACTOR_LEAST 0.4

/* Greatest fraction of diffuse light that the roughness of a material may lose. With a
 * greater loss, slopes are too steep for the model (rough_surface.h). */
#define PP_DOUBTS_LOST_MOST 0.2

/* Adds a warning, with its line in the room file (0: the whole file), for each of
 * these:
 *
 * - a room, block or mesh whose size suggests another unit;
 * - a frame factor or maintenance that looks like a loss;
 * - an opening without a counterpart in the coarse model of the building;
 * - doubts about the data of a measured pane (bsdf.h);
 * - a physically rough material with too steep slopes;
 * - latitude and longitude that are far from the site's country, but near it when
 *   swapped;
 * - if `alone` is set (a file with one room): a room without openings, a block away
 *   from the room that is behind all its openings, and a far skyline in front of a wall
 *   without openings. */
void pp_doubts_find(struct pp_mistakes *doubts, const struct pp_world *world,
                    bool alone);

#endif
