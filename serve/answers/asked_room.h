/* asked_room.h - the room and the options in the body of a request. Inside serve/ only.
 *
 *     { "room": "<room version='1'>...</room>", "options": { "methods": "exact+bre" } }
 */
#ifndef PP_SERVE_ANSWERS_ASKED_ROOM_H
#define PP_SERVE_ANSWERS_ASKED_ROOM_H

#include "serve/work/task.h"

struct pp_asked_room {
    const char *text; /* room file; owned by the task */
    size_t length;
    struct pp_mistakes *mistakes;
    struct pp_building *building;
    struct pp_study *study;
};

/* True if the body has only the members room and options, and its options are among
 * `names` (NULL-terminated). If false, the error answer is set. */
bool pp_asked_room_options(struct pp_task *task, const char *const *names);

/* Gets an option; *option is NULL if it is missing. If it has another JSON type,
 * returns false and sets the error answer. */
bool pp_asked_room_option(struct json_object **option, struct pp_task *task,
                          const char *name, enum json_type type);

/* True if the sky can be used without reading a file, unlike a sky photograph. NULL is
 * allowed. If false, the error answer is set. */
bool pp_asked_room_sky(struct pp_task *task, const char *sky);

/* Gets an option that is a number from `least` to `most`; `usual` if it is missing. If
 * it is invalid, returns false and sets the error answer. */
bool pp_asked_room_number(double *number, struct pp_task *task, const char *name,
                          double usual, double least, double most);

/* Reads the room, with the options "room" (a name), "sky" and "points". The room file
 * must not refer to other files, and must be within the limits of the server. On
 * failure returns false and sets the error answer. The caller clears *asked in any
 * case. */
bool pp_asked_room_open(struct pp_asked_room *asked, struct pp_task *task);
void pp_asked_room_clear(struct pp_asked_room *asked);

/* Checks a room that a child process will read: limits, mistakes, and that it refers to
 * no files. Options are not checked. If false, the error answer is set. */
bool pp_asked_room_check(struct pp_task *task);

/* List of the mistakes in the room; NULL: out of memory. */
struct json_object *pp_asked_room_mistakes(const struct pp_asked_room *asked);

#endif
