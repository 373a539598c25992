/* free_surfaces.h - the step that adds opaque polygons inside the room or outside
 * it, but not through its envelope. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_FREE_SURFACES_H
#define PP_MODEL_ROOM_BUILD_FREE_SURFACES_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_free_surfaces(struct pp_resolver *r, struct pp_error *err);

#endif
