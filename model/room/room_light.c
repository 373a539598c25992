/* room_light.c - makes the sky in the room's axes from its description in words. */
#include "model/room/room_light.h"

#include "model/room/room_parts.h"
#include "model/room/sky_words.h"

enum pp_status pp_room_light(struct pp_outside_light *light, const struct pp_room *room,
                             struct pp_error *err)
{
    struct pp_outside_light made = {.ground_reflectance =
                                        room->site.ground_reflectance};
    enum pp_status status =
        pp_sky_words_sky(&made.sky, &room->sky, room->north_rad, err);
    if (status == PP_OK)
        *light = made;
    return status;
}
