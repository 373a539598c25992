/* placement.h - position of a room in its building: the room's origin, and its rotation
 * about that origin, counter-clockwise seen from above.
 *
 *     p_building = (x, y, z) + R(rotate) p_room
 */
#ifndef PP_MODEL_ROOM_PLACEMENT_H
#define PP_MODEL_ROOM_PLACEMENT_H

#include <math.h>
#include <stdbool.h>

#include "model/geometry/vec.h"

struct pp_placement {
    bool given; /* false: not placed; all other members are 0 */
    double x, y, z, rotate_rad;
};

/* Rotates a direction about the vertical. */
static inline struct pp_vec3 pp_placement_turn(struct pp_vec3 p, double angle_rad)
{
    double c = cos(angle_rad), s = sin(angle_rad);
    return pp_vec(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}

/* Converts a position from the room's axes to the building's, and back. */
static inline struct pp_vec3 pp_placement_to_building(const struct pp_placement *place,
                                                      struct pp_vec3 p)
{
    return pp_vec_add(pp_placement_turn(p, place->rotate_rad),
                      pp_vec(place->x, place->y, place->z));
}

static inline struct pp_vec3 pp_placement_to_room(const struct pp_placement *place,
                                                  struct pp_vec3 p)
{
    return pp_placement_turn(pp_vec_sub(p, pp_vec(place->x, place->y, place->z)),
                             -place->rotate_rad);
}

#endif
