/* size_room.h - the size of one room's windows: what the command size asks of design/,
 * with the methods and the simulation behind it.
 */
#ifndef PP_CLI_SIZE_SIZE_ROOM_H
#define PP_CLI_SIZE_SIZE_ROOM_H

#include "cli/rooms.h"
#include "cli/size/size_options.h"
#include "studies/sizing/size.h"
#include "methods/method.h"
#include "model/room/room_text.h"

/* What was found for one room. */
struct pp_size_room_result {
    const struct pp_loaded_room *room; /* not owned */
    const char *method;                /* that it was sized by; not owned */
    struct pp_size_answer answer;
    struct pp_text_edit *edits; /* what becomes of the room's openings; owned */
    int edit_count;
    const char *file_text; /* not owned */
    size_t file_length;
    int file_opening; /* how many openings the file has before the room's first */
    const char *why;  /* there is no value; not owned */
    struct pp_reading traced; /* of the room sized; NAN where nothing was traced */
    char text[512];           /* what why points to */
};

/* Sizes the room at that index. PP_BAD_INPUT where it has no such window. The result is
 * to be cleared in any case. */
enum pp_status pp_size_room(struct pp_size_room_result *result,
                            const struct pp_rooms *rooms, int index,
                            const struct pp_size_options *options,
                            struct pp_error *err);

/* Makes it the result of a room that can't be sized, and why. */
void pp_size_room_result_refuse(struct pp_size_room_result *result, const char *why);

/* What a method, a pair or "traced" gives: what the target is of. */
enum pp_gives pp_size_room_gives(const char *by);

void pp_size_room_result_clear(struct pp_size_room_result *result);

#endif
