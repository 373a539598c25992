/* json_room.h - the data assumed for a room, as JSON. With these data, results can be
 * reported without the room file. */
#ifndef PP_REPORTS_PARTS_JSON_ROOM_H
#define PP_REPORTS_PARTS_JSON_ROOM_H

#include <json.h>
#include <stdbool.h>

#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Adds "model". Areas are in m2, lengths in m, slopes and angles in degrees.
 * Reflectances and transmittances are fractions, as in a room file. Returns false if
 * memory is exhausted. */
bool pp_json_room_add(struct json_object *object, const struct pp_world *world,
                      const struct pp_outside_light *light);

/* Adds the names of the first opening on a line of the room file. "label" is the name
 * on drawings (the shortened name, or W1). "name" and "wall" are added if the file
 * gives them. Adds nothing if there is no opening on that line. Returns false if memory
 * is exhausted. */
bool pp_json_room_add_opening_names(struct json_object *object,
                                    const struct pp_world *world, int line);

#endif
