/* watertight.h - the step that checks whether the envelope's faces enclose the room.
 * Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_WATERTIGHT_H
#define PP_MODEL_ROOM_BUILD_WATERTIGHT_H

#include "model/room/build/resolve.h"

/* Sets r->watertight. Reverses faces with the wrong orientation and reports them. */
enum pp_status pp_build_watertight(struct pp_resolver *r, struct pp_error *err);

#endif
