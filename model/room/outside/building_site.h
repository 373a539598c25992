/* building_site.h - the placed rooms of a building, each with its surroundings: the
 * building's own blocks, surfaces and skylines, and the other rooms. Inside model/room/
 * only.
 *
 * The placement of a room (x, y, z, rotate) gives its origin in the building's axes,
 * and its rotation about that point, counter-clockwise seen from above:
 *
 *     p_building = (x, y, z) + R(rotate) p_room        north_room = north - rotate
 *
 * The building's parts are transformed to each room's axes by the inverse. Faces of
 * placed rooms, and the parts fixed to their outside (room_shell.h), obstruct other
 * rooms as opaque walls. A room without a placement is at the building's origin and
 * obstructs no other room.
 */
#ifndef PP_MODEL_ROOM_OUTSIDE_BUILDING_SITE_H
#define PP_MODEL_ROOM_OUTSIDE_BUILDING_SITE_H

#include "model/room/read/read_elements.h"

/* Makes building->rooms: the rooms of that state. PP_STATE_BOTH: the rooms that exist
 * in all states, and the mirror image of the placed rooms, reflected in
 * building->boundary. PP_BAD_INPUT if that image is not possible; PP_SYSTEM if memory
 * runs out. After a failure there are no rooms. */
enum pp_status pp_building_site_settle(struct pp_building *building,
                                       enum pp_site_state state, struct pp_error *err);

/* Frees building->rooms. */
void pp_building_site_clear(struct pp_building *building);

#endif
