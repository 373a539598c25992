/* reveals.h - the step that adds the sides of openings' depths. Inside model/room/
 * only. */
#ifndef PP_MODEL_ROOM_BUILD_REVEALS_H
#define PP_MODEL_ROOM_BUILD_REVEALS_H

#include "model/room/build/resolve.h"

/* Adds the reveals, and notes glass that would stand in the room. */
enum pp_status pp_build_reveals(struct pp_resolver *r, struct pp_error *err);

#endif
