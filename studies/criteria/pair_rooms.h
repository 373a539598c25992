/* pair_rooms.h - checks that two rooms are the same room before and after something was
 * built outside, and pairs their openings.
 */
#ifndef PP_STUDIES_CRITERIA_PAIR_ROOMS_H
#define PP_STUDIES_CRITERIA_PAIR_ROOMS_H

#include "model/base/error.h"
#include "model/room/world.h"

/* Sets (*pairs)[i] to the index in `before` of the opening with the outline of opening
 * i of `world`, whatever the order in the files. The caller frees *pairs.
 *
 * Faces, openings and working plane must be in the same places, to 10 mm; surroundings,
 * glass, finishes and sky may differ. Otherwise PP_BAD_INPUT, whose message names the
 * first difference, as the end of a sentence that begins with the file's name.
 */
enum pp_status pp_pair_rooms(int **pairs, const struct pp_world *world,
                             const struct pp_world *before, struct pp_error *err);

#endif
