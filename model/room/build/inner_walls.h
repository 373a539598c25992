/* inner_walls.h - the step that finds the walls behind which there is another room or
 * another's house. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_INNER_WALLS_H
#define PP_MODEL_ROOM_BUILD_INNER_WALLS_H

#include "model/room/build/resolve.h"

/* Marks inner walls: those stated in the file, and those with another placed room right
 * behind them. Notes walls that are said to be, but have openings. */
enum pp_status pp_build_inner_walls(struct pp_resolver *r, struct pp_error *err);

#endif
