/* json_room.h - the data assumed for a room, as JSON: enough to report the results
 * without the room file. */
#ifndef PP_REPORTS_PARTS_JSON_ROOM_H
#define PP_REPORTS_PARTS_JSON_ROOM_H

#include <json.h>
#include <stdbool.h>

#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Adds "model": areas (m2), lengths (m), reflectances and transmittances as fractions
 * as in a room file, slopes and angles in degrees. False: out of memory. */
bool pp_json_room_add(struct json_object *object, const struct pp_world *world,
                      const struct pp_outside_light *light);

/* Adds the names of the first opening on a line of the room file: "label", as on
 * drawings (its name shortened, or W1), and "name" and "wall" if the file gives them.
 * Adds nothing if there is no opening on that line. False: out of memory. */
bool pp_json_room_add_opening_names(struct json_object *object,
                                    const struct pp_world *world, int line);

#endif
