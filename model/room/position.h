/* position.h - is a point in the room, and can light be measured there? */
#ifndef PP_MODEL_ROOM_POSITION_H
#define PP_MODEL_ROOM_POSITION_H

#include <stdbool.h>

#include "model/room/world.h"

/* Does a point lie within the room's envelope? For a point exactly on it
 * the answer may be either. */
bool pp_position_in_room(const struct pp_world *world, struct pp_vec3 point);

/* Bounds of the room, and whether an object with these corners comes within 2 mm of
 * them. */
struct pp_bounds3 pp_position_bounds(const struct pp_world *world);
bool pp_position_is_near(const struct pp_bounds3 *room, const struct pp_vec3 *corners,
                         int count);

/* Is the point in a face or any other surface of the world, to a tenth of a
 * millimetre? */
bool pp_position_in_surface(const struct pp_world *world, struct pp_vec3 point);

/* Is the point within furniture, a column or a partition, or on their sides? */
bool pp_position_in_fitting(const struct pp_world *world, struct pp_vec3 point);

/* Fault of a receiver at this position with that unit normal, as the end of a sentence
 * ("lies outside the room", "lies in an opening"), or NULL if there is none. A receiver
 * may lie on floor, walls and ceiling if it faces straight into the room. */
const char *pp_position_receiver_fault(const struct pp_world *world,
                                       struct pp_vec3 position, struct pp_vec3 normal);

/* The surfaces of a world that come near a box, for many receivers in it. */
struct pp_position_surfaces {
    int *list; /* indices, in order */
    int count;
};

/* On success the list is the caller's to free. */
enum pp_status pp_position_find_surfaces(struct pp_position_surfaces *surfaces,
                                         const struct pp_world *world,
                                         const struct pp_bounds3 *box,
                                         struct pp_error *err);

/* pp_position_receiver_fault for a position in the box of these surfaces. */
const char *pp_position_fault_among(const struct pp_world *world,
                                    const struct pp_position_surfaces *surfaces,
                                    struct pp_vec3 position, struct pp_vec3 normal);

/* A receiver that faces up at a place, z NAN: on the working plane; PP_BAD_INPUT where
 * light can't be measured there. */
enum pp_status pp_position_place_receiver(struct pp_receiver *receiver,
                                          const struct pp_world *world,
                                          struct pp_vec3 place, struct pp_error *err);

#endif
