/* pair_rooms.h - checks that two rooms are the same room before and after something was
 * built outside, and pairs their openings.
 */
#ifndef PP_STUDIES_CRITERIA_PAIR_ROOMS_H
#define PP_STUDIES_CRITERIA_PAIR_ROOMS_H

#include "model/base/error.h"
#include "model/room/world.h"

/* (*pairs)[i] is the index in `before` of the opening whose outline is that of the i-th
 * opening of `world`, whatever the order in the files. *pairs is the caller's to free.
 *
 * Faces, openings and working plane must be in the same places, to 10 mm; surroundings,
 * glass, finishes and sky may differ. Else PP_BAD_INPUT, whose message names the first
 * difference, as the end of a sentence that begins with the file's name. */
enum pp_status pp_pair_rooms(int **pairs, const struct pp_world *world,
                             const struct pp_world *before, struct pp_error *err);

#endif
