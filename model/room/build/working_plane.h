/* working_plane.h - the step that sets the working plane and the room's section by it.
 * Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_WORKING_PLANE_H
#define PP_MODEL_ROOM_BUILD_WORKING_PLANE_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_working_plane(struct pp_resolver *r, struct pp_error *err);

#endif
