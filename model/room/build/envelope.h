/* envelope.h - the step from the plan, or the faces of an envelope, to the room's own
 * surfaces. Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_BUILD_ENVELOPE_H
#define PP_MODEL_ROOM_BUILD_ENVELOPE_H

#include "model/room/build/resolve.h"

/* The world's first surfaces, with the reflectances of their finishes, and the names of
 * the walls. */
enum pp_status pp_build_envelope(struct pp_resolver *r, struct pp_error *err);

#endif
