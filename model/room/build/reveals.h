/* reveals.h - the step that adds the reveals of openings. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_REVEALS_H
#define PP_MODEL_ROOM_BUILD_REVEALS_H

#include "model/room/build/resolve.h"

/* Adds the reveals; reports glass that would be inside the room. */
enum pp_status pp_build_reveals(struct pp_resolver *r, struct pp_error *err);

#endif
