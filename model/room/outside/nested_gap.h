/* nested_gap.h - the gap of a facade in the plane of a wall, beside a nested room.
 *
 * A facade in the plane of its wall has a gap for that wall. If the coarse model is in
 * the place of the room, the room's own walls stand in the gap. Inside model/room/
 * only.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_NESTED_GAP_H
#define PP_MODEL_ROOM_OUTSIDE_NESTED_GAP_H

#include "model/room/build/resolve.h"
#include "model/room/face_less_openings.h"
#include "model/room/placement.h"

/* Sets gap to the part of the gap beside the room: the wall of the coarse model, without
 * regard to its windows, less the rectangle that the room covers, in the plane of the
 * wall. place: converts from the axes of the coarse model. axes: of the wall. The walls
 * of the room that stand in the gap get the facade's reflectance. The caller clears the
 * gap in any case. */
enum pp_status pp_nested_gap_find(struct pp_region *gap, struct pp_resolver *r,
                                  const struct pp_world *coarse,
                                  const struct pp_placement *place,
                                  const struct pp_facade *facade,
                                  const struct pp_face_axes *axes,
                                  struct pp_error *err);

#endif
