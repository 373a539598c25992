/* self_occlusion.h - marks openings that the room's own faces cannot hide. Inside model/room/
 * only. */
#ifndef PP_MODEL_ROOM_BUILD_SELF_OCCLUSION_H
#define PP_MODEL_ROOM_BUILD_SELF_OCCLUSION_H

#include "model/room/build/resolve.h"

/* Whether faces can hide each opening on its inner side and on its outer, and whether
 * surfaces stand in the room. */
enum pp_status pp_build_self_occlusion(struct pp_resolver *r, struct pp_error *err);

#endif
