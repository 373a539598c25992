/* covers.h - the step that puts doors and dados before the walls that they lie in, as
 * surfaces of another reflectance. Inside model/room/ only.
 *
 * A cover is set off its wall by PP_SET_OFF_M into the room: rays meet it and not the
 * wall. It hides nothing, and a mean of reflectances counts it in its wall's place. A
 * dado leaves out openings and doors.
 */
#ifndef PP_MODEL_ROOM_BUILD_COVERS_H
#define PP_MODEL_ROOM_BUILD_COVERS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_covers(struct pp_resolver *r, struct pp_error *err);

#endif
