/* room_light.h - the outdoor light given in a room's file: the sky, and the reflectance
 * of the ground. Outdoor light is not part of a world; methods and simulations take it
 * as a separate argument. */
#ifndef PP_MODEL_ROOM_ROOM_LIGHT_H
#define PP_MODEL_ROOM_ROOM_LIGHT_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/building.h"

/* Outdoor light of a room, in the axes of its world. PP_BAD_INPUT if its sky needs a
 * sun that is not given or is below the horizon. This cannot happen for rooms from
 * files, or after pp_room_set_sky, which both reject such a sky. On failure *light is
 * unchanged. */
enum pp_status pp_room_light(struct pp_outside_light *light, const struct pp_room *room,
                             struct pp_error *err);

#endif
