/* device_states.h - a room with its blinds, screens and curtains in another state.
 *
 * Such a world shares everything except the openings with the world that it is made of,
 * which must outlive it.
 */
#ifndef PP_MODEL_ROOM_BUILD_DEVICE_STATES_H
#define PP_MODEL_ROOM_BUILD_DEVICE_STATES_H

#include "model/room/world.h"

/* True if an opening has a blind, a screen or a curtain. */
bool pp_device_states_exist(const struct pp_world *world);

/* The room without its devices: blinds are raised, curtains are drawn back. On success
 * the caller destroys *open. */
enum pp_status pp_device_states_open(struct pp_world **open,
                                     const struct pp_world *world,
                                     struct pp_error *err);
void pp_device_states_destroy(struct pp_world *state); /* NULL is allowed */

#endif
