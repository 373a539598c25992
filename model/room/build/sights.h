/* sights.h - the step that finds which openings the envelope can't come before. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_SIGHTS_H
#define PP_MODEL_ROOM_BUILD_SIGHTS_H

#include "model/room/build/resolve.h"

/* Whether faces can hide each opening on its inner side and on its outer, and whether
 * surfaces stand in the room. */
enum pp_status pp_build_sights(struct pp_resolver *r, struct pp_error *err);

#endif
