/* outline.h - checks a single polygon of the room file. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_OUTLINE_H
#define PP_MODEL_ROOM_BUILD_OUTLINE_H

#include "model/room/build/resolve.h"

/* Reports faults of an outline: too few or repeated vertices, no area, not planar, or
 * self-intersection. `what` begins the message. True if there is no fault; false
 * without a message if a coordinate could not be read. */
bool pp_build_outline_is_good(struct pp_resolver *r, const char *what, int line,
                              const struct pp_vertices *vertices);

#endif
