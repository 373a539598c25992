/* room_use.h - the use of a room, which decides which criteria apply. */
#ifndef PP_MODEL_ROOM_ROOM_USE_H
#define PP_MODEL_ROOM_ROOM_USE_H

enum pp_room_use {
    PP_USE_UNKNOWN,
    PP_USE_BEDROOM,
    PP_USE_LIVING_ROOM,
    PP_USE_DINING_ROOM,
    PP_USE_KITCHEN,
    PP_USE_LIVING_KITCHEN, /* living room with a kitchen */
    PP_USE_STUDIO,         /* one room for living, cooking and sleeping */
    PP_USE_STUDY,
    PP_USE_OFFICE,
    PP_USE_MEETING_ROOM,
    PP_USE_CLASSROOM,
    PP_USE_WARD,
    PP_USE_SHOP,
    PP_USE_WORKSHOP,
    PP_USE_BATHROOM,
    PP_USE_CIRCULATION, /* halls, stairs, corridors */
    PP_USE_STORE,
    PP_USE_OTHER,
    PP_USE_COUNT
};

/* Words of room files by enum pp_room_use; PP_USE_UNKNOWN is "unknown";
 * NULL-terminated. */
extern const char *const pp_room_use_words[];

#endif
