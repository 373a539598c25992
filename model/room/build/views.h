/* views.h - the step that places the views of a room. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_VIEWS_H
#define PP_MODEL_ROOM_BUILD_VIEWS_H

#include "model/room/build/resolve.h"

/* Makes the views of the room file. */
enum pp_status pp_build_views(struct pp_resolver *r, struct pp_error *err);

#endif
