/* asked_room.h - the room and the options that a request carries. Inside serve/ only.
 *
 *     { "room": "<room version='1'>...</room>", "options": { "methods": "exact+bre" } }
 */
#ifndef PP_SERVE_ANSWERS_ASKED_ROOM_H
#define PP_SERVE_ANSWERS_ASKED_ROOM_H

#include "serve/work/task.h"

struct pp_asked_room {
    const char *text; /* of the room file; the task's */
    size_t length;
    struct pp_mistakes *mistakes;
    struct pp_building *building;
    struct pp_study *study;
};

/* True if the request's options are among these, and the body has the members room and
 * options only. If false, the answer is set. names ends with NULL. */
bool pp_asked_room_options(struct pp_task *task, const char *const *names);

/* Gets an option of a JSON type; NULL: it is not there. False: it has another type, and
 * the answer is set. */
bool pp_asked_room_option(struct json_object **option, struct pp_task *task,
                          const char *name, enum json_type type);

/* True if the sky needs no file (a photograph does); NULL is allowed. If false, the
 * answer is set. */
bool pp_asked_room_sky(struct pp_task *task, const char *sky);

/* Gets a number from `least` to `most`; `usual` if the option is missing. False: the
 * answer is set. */
bool pp_asked_room_number(double *number, struct pp_task *task, const char *name,
                          double usual, double least, double most);

/* Reads the room, which names no files, with the options "room" (a name) and "sky" and
 * "points", within the limits of the server. False: the answer is set; cleared in any case
 * by pp_asked_room_clear. */
bool pp_asked_room_open(struct pp_asked_room *asked, struct pp_task *task);
void pp_asked_room_clear(struct pp_asked_room *asked);

/* Checks the room of a request for a child process: its limits and mistakes, and that it
 * names no files. The options are the command's own and are not read. False: the answer is
 * set. */
bool pp_asked_room_check(struct pp_task *task);

/* The mistakes of the room as a list; NULL: memory is out. */
struct json_object *pp_asked_room_mistakes(const struct pp_asked_room *asked);

#endif
