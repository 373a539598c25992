/* blocks.h - the step that adds blocks: boxes that must not overlap the room or a
 * reveal. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_OUTSIDE_BLOCKS_H
#define PP_MODEL_ROOM_OUTSIDE_BLOCKS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_blocks(struct pp_resolver *r, struct pp_error *err);

#endif
