/* room_light.c - the words for a room's sky become that sky, turned into its axes. */
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
