/* building_site.h - the rooms of a building where they stand, each with all that stands
 * outside it: the building's own blocks, surfaces and skylines, and the other rooms.
 * Inside model/room/ only.
 *
 * A room that is placed (x, y, z, rotate) has its origin there, in the building's axes,
 * and is turned about it, counter-clockwise seen from above:
 *
 *     p_building = (x, y, z) + R(rotate) p_room        north_room = north - rotate
 *
 * What the building holds goes into each room's own axes by the inverse. Faces of placed
 * rooms stand before the others as opaque outside walls, and with them what is fixed
 * outside (room_shell.h). A room that is not placed stands by itself, at the building's
 * origin, and before no other.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_BUILDING_SITE_H
#define PP_MODEL_ROOM_OUTSIDE_BUILDING_SITE_H

#include "model/room/read/read_elements.h"

/* Makes building->rooms anew: those that there are in that state (PP_STATE_EXISTING or
 * PP_STATE_PROPOSED), or with PP_STATE_BOTH what there is in both, and the mirror image of
 * the placed rooms at building->boundary. Fails where memory is out, or where there is no
 * such image (PP_BAD_INPUT); then there are none. */
enum pp_status pp_building_site_settle(struct pp_building *building,
                                       enum pp_site_state state, struct pp_error *err);

/* Frees building->rooms. */
void pp_building_site_clear(struct pp_building *building);

#endif
