/* place_openings.h - the step that places windows, rooflights and glazed polygons in
 * the faces that contain them. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_PLACE_OPENINGS_H
#define PP_MODEL_ROOM_BUILD_PLACE_OPENINGS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_place_openings(struct pp_resolver *r, struct pp_error *err);

#endif
