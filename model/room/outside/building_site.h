/* building_site.h - the placed rooms of a building, each with its surroundings: the
 * building's own blocks, surfaces and skylines, and the other rooms. Inside model/room/
 * only.
 *
 * A placed room (x, y, z, rotate) has its origin there, in the building's axes, and is
 * rotated about it, counter-clockwise seen from above:
 *
 *     p_building = (x, y, z) + R(rotate) p_room        north_room = north - rotate
 *
 * The building's parts are moved to each room's own axes by the inverse. Faces of
 * placed rooms obstruct the others as opaque outside walls, with the parts fixed to
 * their outside (room_shell.h). A room without a place stands alone, at the building's
 * origin, and obstructs no other.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_BUILDING_SITE_H
#define PP_MODEL_ROOM_OUTSIDE_BUILDING_SITE_H

#include "model/room/read/read_elements.h"

/* Makes building->rooms anew: the rooms of that state (PP_STATE_EXISTING or
 * PP_STATE_PROPOSED). With PP_STATE_BOTH it makes those of both states, and the mirror
 * image of the placed rooms at building->boundary. Fails if out of memory, or if there
 * is no such image (PP_BAD_INPUT); there are then no rooms. */
enum pp_status pp_building_site_settle(struct pp_building *building,
                                       enum pp_site_state state, struct pp_error *err);

/* Frees building->rooms. */
void pp_building_site_clear(struct pp_building *building);

#endif
