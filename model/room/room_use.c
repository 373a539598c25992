/* room_use.c - see room_use.h. */
#include "model/room/room_use.h"

#include <stddef.h>

const char *const pp_room_use_words[] = {
    [PP_USE_UNKNOWN] = "unknown",
    [PP_USE_BEDROOM] = "bedroom",
    [PP_USE_LIVING_ROOM] = "living-room",
    [PP_USE_DINING_ROOM] = "dining-room",
    [PP_USE_KITCHEN] = "kitchen",
    [PP_USE_LIVING_KITCHEN] = "living-kitchen",
    [PP_USE_STUDIO] = "studio",
    [PP_USE_STUDY] = "study",
    [PP_USE_OFFICE] = "office",
    [PP_USE_MEETING_ROOM] = "meeting-room",
    [PP_USE_CLASSROOM] = "classroom",
    [PP_USE_WARD] = "ward",
    [PP_USE_SHOP] = "shop",
    [PP_USE_WORKSHOP] = "workshop",
    [PP_USE_BATHROOM] = "bathroom",
    [PP_USE_CIRCULATION] = "circulation",
    [PP_USE_STORE] = "store",
    [PP_USE_OTHER] = "other",
    [PP_USE_COUNT] = NULL,
};
