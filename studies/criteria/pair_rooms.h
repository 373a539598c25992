/* pair_rooms.h - is it the same room, before and after something was built outside? */
#ifndef PP_STUDIES_CRITERIA_PAIR_ROOMS_H
#define PP_STUDIES_CRITERIA_PAIR_ROOMS_H

#include "model/base/error.h"
#include "model/room/world.h"

/* Finds each opening of `world` in `before`: *pairs, to be freed, has the index there
 * of each, by the place of its outline, whatever the order in the files.
 *
 * The room has to be the same: its faces, openings and working plane in the same
 * places, to 10 mm. Surroundings, glass, finishes and sky may differ. Else
 * PP_BAD_INPUT, with the first thing that does not agree, as the end of a sentence that
 * begins with the file's name. */
enum pp_status pp_pair_rooms(int **pairs, const struct pp_world *world,
                             const struct pp_world *before, struct pp_error *err);

#endif
