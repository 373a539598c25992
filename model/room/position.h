/* position.h - tests whether a point is in the room, and whether a receiver can be
 * there. */
#ifndef PP_MODEL_ROOM_POSITION_H
#define PP_MODEL_ROOM_POSITION_H

#include <stdbool.h>

#include "model/room/world.h"

/* True if the point is inside the room's envelope; either result for a point on the
 * envelope. */
bool pp_position_in_room(const struct pp_world *world, struct pp_vec3 point);

/* Bounds of the room. The second function returns true if the bounds of these corners
 * come within 2 mm of the room's bounds. */
struct pp_bounds3 pp_position_bounds(const struct pp_world *world);
bool pp_position_is_near(const struct pp_bounds3 *room, const struct pp_vec3 *corners,
                         int count);

/* True if the point is within 0.1 mm of a surface of the world. */
bool pp_position_in_surface(const struct pp_world *world, struct pp_vec3 point);

/* True if the point is inside furniture, a column or a partition, or on their sides. */
bool pp_position_in_fitting(const struct pp_world *world, struct pp_vec3 point);

/* Fault of a receiver at this position with that unit normal, as the end of a sentence
 * ("lies outside the room", "lies in an opening"); NULL if valid. A receiver may be on
 * floor, walls and ceiling if it faces straight into the room. */
const char *pp_position_receiver_fault(const struct pp_world *world,
                                       struct pp_vec3 position, struct pp_vec3 normal);

/* A view without a name, from an eye that looks along that bearing. */
struct pp_world_view pp_position_view(const struct pp_world *world, struct pp_vec3 eye,
                                      double bearing_rad);

/* The surfaces of a world near a box, for many receivers in the box. */
struct pp_position_surfaces {
    int *list; /* indices, in order */
    int count;
};

/* Finds the surfaces near the box. On success the caller frees the list. */
enum pp_status pp_position_find_surfaces(struct pp_position_surfaces *surfaces,
                                         const struct pp_world *world,
                                         const struct pp_bounds3 *box,
                                         struct pp_error *err);

/* pp_position_receiver_fault for a position in the box of these surfaces. */
const char *pp_position_fault_among(const struct pp_world *world,
                                    const struct pp_position_surfaces *surfaces,
                                    struct pp_vec3 position, struct pp_vec3 normal);

/* Makes a receiver that faces up at a place; z NAN: on the working plane. PP_BAD_INPUT
 * if no receiver can be there. */
enum pp_status pp_position_place_receiver(struct pp_receiver *receiver,
                                          const struct pp_world *world,
                                          struct pp_vec3 place, struct pp_error *err);

#endif
