/* outline.h - is a polygon of the room file a good one by itself? Inside model/room/
 * only. */
#ifndef PP_MODEL_ROOM_BUILD_OUTLINE_H
#define PP_MODEL_ROOM_BUILD_OUTLINE_H

#include "model/room/build/resolve.h"

/* Notes faults of an outline by itself: too few vertices, repeated ones, no area, not
 * plane, crossing itself. `what` begins the sentence. True if it has no fault; false,
 * with nothing noted, where a coordinate could not be read. */
bool pp_build_outline_is_good(struct pp_resolver *r, const char *what, int line,
                              const struct pp_vertices *vertices);

#endif
