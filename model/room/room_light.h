/* room_light.h - the light from outside that a room's file describes: its sky, and the
 * reflectance of its ground. A world does not contain it: it is a separate argument of
 * methods and simulations. */
#ifndef PP_MODEL_ROOM_ROOM_LIGHT_H
#define PP_MODEL_ROOM_ROOM_LIGHT_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/building.h"

/* The light of a room, in the axes of its world. PP_BAD_INPUT where its sky needs a sun
 * that is not given, or that stands below the horizon; the reader of room files and
 * pp_room_set_sky refuse both, so that it does not fail for a room that they made. On
 * failure *light stays as it was. */
enum pp_status pp_room_light(struct pp_outside_light *light, const struct pp_room *room,
                             struct pp_error *err);

#endif
