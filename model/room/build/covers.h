/* covers.h - the step that adds doors and dados: surfaces in front of a wall, with a
 * different reflectance. Inside model/room/ only.
 *
 * A cover is offset from its wall into the room, by PP_SET_OFF_M plus twice the wall's
 * unevenness, so that rays hit the cover. It obstructs nothing else. In mean
 * reflectances a cover replaces the part of the wall behind it. A dado leaves out
 * openings and doors.
 */
#ifndef PP_MODEL_ROOM_BUILD_COVERS_H
#define PP_MODEL_ROOM_BUILD_COVERS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_covers(struct pp_resolver *r, struct pp_error *err);

#endif
