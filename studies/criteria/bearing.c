/* bearing.c - see bearing.h. */
#include "studies/criteria/bearing.h"

#include <string.h>

int pp_bearing_dwelling_rooms(enum pp_room_use use)
{
    switch (use) {
    case PP_USE_UNKNOWN:
        return PP_DWELLING_BEDROOM | PP_DWELLING_LIVING_ROOM | PP_DWELLING_KITCHEN;
    case PP_USE_BEDROOM:
        return PP_DWELLING_BEDROOM;
    case PP_USE_LIVING_ROOM:
    case PP_USE_DINING_ROOM:
        return PP_DWELLING_LIVING_ROOM;
    case PP_USE_KITCHEN:
    case PP_USE_LIVING_KITCHEN:
    case PP_USE_STUDIO:
        return PP_DWELLING_KITCHEN;
    default:
        return 0;
    }
}

bool pp_bearing_is_dwelling(enum pp_room_use use)
{
    return pp_bearing_dwelling_rooms(use) != 0;
}

bool pp_bearing_is_lived_in(enum pp_room_use use)
{
    return use == PP_USE_UNKNOWN || use == PP_USE_LIVING_ROOM
           || use == PP_USE_LIVING_KITCHEN || use == PP_USE_STUDIO;
}

bool pp_bearing_needs_daylight(enum pp_room_use use)
{
    return use != PP_USE_BATHROOM && use != PP_USE_CIRCULATION && use != PP_USE_STORE;
}

bool pp_bearing_bears(const struct pp_criterion *criterion,
                      const struct pp_world *world, bool by_country)
{
    bool here = !by_country || !criterion->countries || !world->country[0]
                || strstr(criterion->countries, world->country);
    return here && (!criterion->bears_on_use || criterion->bears_on_use(world->use));
}
