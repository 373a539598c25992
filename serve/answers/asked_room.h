/* asked_room.h - the room and the options in the body of a request. For use inside
 * serve/ only.
 *
 *     { "room": "<room version='1'>...</room>", "options": { "methods": "exact+bre" } }
 */
#ifndef PP_SERVE_ANSWERS_ASKED_ROOM_H
#define PP_SERVE_ANSWERS_ASKED_ROOM_H

#include "serve/work/task.h"

struct pp_asked_room {
    const char *text; /* text of the room file; owned by the task */
    size_t length;
    struct pp_mistakes *mistakes;
    struct pp_building *building;
    struct pp_study *study;
};

/* Checks that "options", if present, is an object with only the names in `names`
 * (NULL-terminated). Otherwise returns false and sets the error answer. */
bool pp_asked_room_options(struct pp_task *task, const char *const *names);

/* Gets an option. *option is NULL if it is missing. If the option has another JSON
 * type, returns false and sets the error answer. */
bool pp_asked_room_option(struct json_object **option, struct pp_task *task,
                          const char *name, enum json_type type);

/* Checks that the sky does not require reading a file, unlike a sky photograph. NULL is
 * permitted. Otherwise returns false and sets the error answer. */
bool pp_asked_room_sky(struct pp_task *task, const char *sky);

/* Gets an option that is a number from `least` to `most`. If the option is missing,
 * *number is `usual`. If it is invalid, returns false and sets the error answer. */
bool pp_asked_room_number(double *number, struct pp_task *task, const char *name,
                          double usual, double least, double most);

/* Reads the room, and applies the options "room" (a name), "sky" and "points". The room
 * file must not refer to other files, and must be within the limits of the server.
 * Otherwise returns false and sets the error answer. The caller clears *asked, also
 * after a failure. */
bool pp_asked_room_open(struct pp_asked_room *asked, struct pp_task *task);
void pp_asked_room_clear(struct pp_asked_room *asked);

/* Checks a room before a child process reads it: limits, errors, and that it does not
 * refer to files. Options are not checked. If the room is not valid, returns false and
 * sets the error answer. */
bool pp_asked_room_check(struct pp_task *task);

/* List of the errors in the room file; NULL: out of memory. */
struct json_object *pp_asked_room_mistakes(const struct pp_asked_room *asked);

#endif
