/* room_text.h - the text of a room file with some of its windows changed: everything
 * else, comments and blanks too, stays byte for byte.
 */
#ifndef PP_MODEL_ROOM_ROOM_TEXT_H
#define PP_MODEL_ROOM_ROOM_TEXT_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/room/room.h"

enum pp_text_edit_kind {
    PP_TEXT_SET,   /* its place becomes this one */
    PP_TEXT_ADD,   /* one like it, in this place, behind it */
    PP_TEXT_REMOVE /* it is left out */
};

/* One edit of the opening-th window, rooflight or opening of the file, from 0, whatever
 * room of a building it is in; of windows and rooflights only. */
struct pp_text_edit {
    enum pp_text_edit_kind kind;
    int opening;
    struct pp_opening_place place;
};

/* The text, which pp_building_parse has found no mistake in, with the edits made, in
 * order of their openings. *changed is the caller's, *changed_length bytes and a 0. */
enum pp_status pp_edit_text(char **changed, size_t *changed_length, const char *text,
                            size_t length, const struct pp_text_edit *edits,
                            int edit_count, struct pp_error *err);

/* The opening's own element as the edit (of PP_TEXT_SET or PP_TEXT_ADD) has it, from
 * "<" to ">"; the caller's. */
enum pp_status pp_edit_text_element(char **element, const char *text, size_t length,
                                    const struct pp_text_edit *edit,
                                    struct pp_error *err);

#endif
