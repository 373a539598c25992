/* fittings.h - the step that adds furniture, columns and partitions as surfaces in the
 * room. Inside model/room/ only.
 *
 * Each object is a box; a round column is a prism of twelve sides with the same area.
 * Sides on the floor or at the ceiling are left out, since no light reaches them.
 */
#ifndef PP_MODEL_ROOM_BUILD_FITTINGS_H
#define PP_MODEL_ROOM_BUILD_FITTINGS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_fittings(struct pp_resolver *r, struct pp_error *err);

#endif
