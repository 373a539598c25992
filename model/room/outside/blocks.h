/* blocks.h - the step that adds blocks outside: boxes that must not touch the inside of
 * the room. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_OUTSIDE_BLOCKS_H
#define PP_MODEL_ROOM_OUTSIDE_BLOCKS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_blocks(struct pp_resolver *r, struct pp_error *err);

#endif
