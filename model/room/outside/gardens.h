/* gardens.h - the step that lays out the pieces of ground that the sun is to reach. Inside
 * model/room/ only.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_GARDENS_H
#define PP_MODEL_ROOM_OUTSIDE_GARDENS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_gardens(struct pp_resolver *r, struct pp_error *err);

#endif
