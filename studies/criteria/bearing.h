/* bearing.h - applicability of a criterion to a room, from the room's use and
 * country. */
#ifndef PP_STUDIES_CRITERIA_BEARING_H
#define PP_STUDIES_CRITERIA_BEARING_H

#include <stdbool.h>

#include "model/room/room_use.h"
#include "model/room/world.h"
#include "studies/criteria/criterion.h"

/* Kinds of rooms of a dwelling for which British guidance has separate figures, as
 * bits. */
enum pp_dwelling_room {
    PP_DWELLING_BEDROOM = 1,
    PP_DWELLING_LIVING_ROOM = 2,
    PP_DWELLING_KITCHEN = 4
};

/* Kinds of habitable room to which the room belongs. A room with several uses counts as
 * the kind with the highest target [BS8206], a room of unknown use as all kinds; 0: not
 * a habitable room of a dwelling. */
int pp_bearing_dwelling_rooms(enum pp_room_use use);

/* Values for bears_on_use of criteria. */
bool pp_bearing_needs_daylight(enum pp_room_use use); /* all uses except bathroom,
                                                       * hall and store */
bool pp_bearing_is_dwelling(enum pp_room_use use);
bool pp_bearing_is_lived_in(enum pp_room_use use); /* at least part of the room is a
                                                    * living room, or the use is
                                                    * unknown */

/* True if the criterion applies to the room's use and, if by_country, to the site's
 * country. An unknown use or country is no obstacle. */
bool pp_bearing_bears(const struct pp_criterion *criterion,
                      const struct pp_world *world, bool by_country);

#endif
