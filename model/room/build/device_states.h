/* device_states.h - a room with its blinds, screens and curtains in another state.
 *
 * Such a world shares everything except the openings with the world that it is made
 * from, which must outlive it.
 */
#ifndef PP_MODEL_ROOM_BUILD_DEVICE_STATES_H
#define PP_MODEL_ROOM_BUILD_DEVICE_STATES_H

#include "model/room/world.h"

/* True if an opening has a blind, a screen or a curtain. */
bool pp_device_states_exist(const struct pp_world *world);

/* A copy of the world, to be changed in part. On success the caller destroys *copy by
 * pp_device_states_destroy. */
enum pp_status pp_device_states_copy(struct pp_world **copy,
                                     const struct pp_world *world,
                                     struct pp_error *err);

/* The room without its devices: blinds are raised, curtains are drawn back. On success
 * the caller destroys *open. */
enum pp_status pp_device_states_open(struct pp_world **open,
                                     const struct pp_world *world,
                                     struct pp_error *err);
void pp_device_states_destroy(struct pp_world *state); /* NULL is allowed */

/* True if slats of the opening follow the sun. */
bool pp_device_states_follows(const struct pp_opening *opening);

/* Angle of such slats for the sun in that direction (unit, in the room's axes); 0 if the
 * sun is not in front of the window, or below the horizon. */
double pp_device_states_tilt(const struct pp_opening *opening, struct pp_vec3 sun);

/* Changes the world: turns all slats that follow the sun to their angle for the sun in
 * that direction. has_sun false: there is no direct sunlight, and the slats are set to
 * 0 degrees. */
enum pp_status pp_device_states_turn(struct pp_world *world, bool has_sun,
                                     struct pp_vec3 sun, struct pp_error *err);

/* The room with all slats that follow the sun at one angle, tilt_rad, for light from
 * the sky. Direct sunlight still passes slats at the angle that follows the sun; the
 * data for it are shared with the state `other`, or calculated if that is NULL. On
 * success the caller destroys *state. */
enum pp_status pp_device_states_tilted(struct pp_world **state,
                                       const struct pp_world *world, double tilt_rad,
                                       const struct pp_world *other,
                                       struct pp_error *err);

#endif
