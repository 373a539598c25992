/* corners.h - the step that merges corners of the envelope that nearly coincide. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_CORNERS_H
#define PP_MODEL_ROOM_BUILD_CORNERS_H

#include "model/room/build/resolve.h"

/* Gives points nearer than PP_SAME_M (by more than PP_ROUNDING_M) exactly equal
 * coordinates, so that later steps can match edges of neighbouring faces. Fills
 * r->corners with the numbers of the points. This closes gaps below 1 mm; a gap of 1 mm
 * stays open. */
enum pp_status pp_build_corners(struct pp_resolver *r, struct pp_error *err);

#endif
