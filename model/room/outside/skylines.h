/* skylines.h - the step that adds infinitely long obstructions parallel to a wall.
 * Inside model/room/ only. Comes after the openings and the ground. */
#ifndef PP_MODEL_ROOM_OUTSIDE_SKYLINES_H
#define PP_MODEL_ROOM_OUTSIDE_SKYLINES_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_skylines(struct pp_resolver *r, struct pp_error *err);

#endif
