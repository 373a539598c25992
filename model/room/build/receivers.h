/* receivers.h - the step that places points, lines and grids of receivers. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_RECEIVERS_H
#define PP_MODEL_ROOM_BUILD_RECEIVERS_H

#include "model/room/build/resolve.h"

/* Makes the receivers of the room file, or of the default grid if the file has none. */
enum pp_status pp_build_receivers(struct pp_resolver *r, struct pp_error *err);

#endif
