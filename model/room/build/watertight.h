/* watertight.h - the step that finds out whether the envelope's faces close the room.
 * Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_WATERTIGHT_H
#define PP_MODEL_ROOM_BUILD_WATERTIGHT_H

#include "model/room/build/resolve.h"

/* Sets r->watertight; turns faces round that turn the wrong way, and notes them. */
enum pp_status pp_build_watertight(struct pp_resolver *r, struct pp_error *err);

#endif
