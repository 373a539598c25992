/* fittings.h - the step that adds the objects in a room: furniture, columns and
 * partitions, as surfaces inside. Inside model/room/ only.
 *
 * Each is a box, a round column a prism of twelve sides of the same area. A side on the
 * floor and one at the ceiling are left out: no light comes to them.
 */
#ifndef PP_MODEL_ROOM_BUILD_FITTINGS_H
#define PP_MODEL_ROOM_BUILD_FITTINGS_H

#include "model/room/build/resolve.h"

enum pp_status pp_build_fittings(struct pp_resolver *r, struct pp_error *err);

#endif
