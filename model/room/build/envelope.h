/* envelope.h - the step that makes the room's surfaces from its plan, or from the faces
 * of its envelope. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_ENVELOPE_H
#define PP_MODEL_ROOM_BUILD_ENVELOPE_H

#include "model/room/build/resolve.h"

/* Adds the first surfaces of the world, with the reflectances of their finishes, and
 * the names of the walls. */
enum pp_status pp_build_envelope(struct pp_resolver *r, struct pp_error *err);

#endif
