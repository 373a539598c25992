/* room_text.h - changes windows in the text of a room file, or paths if the file moves
 * to another folder; everything else stays byte for byte the same. */
#ifndef PP_MODEL_ROOM_TEXT_ROOM_TEXT_H
#define PP_MODEL_ROOM_TEXT_ROOM_TEXT_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/room/room.h"

enum pp_text_edit_kind {
    PP_TEXT_SET,   /* the opening gets the given place */
    PP_TEXT_ADD,   /* a copy of the opening in that place is added after it */
    PP_TEXT_REMOVE /* the opening is removed */
};

/* One edit of a window or rooflight. `opening` is its index among the windows,
 * rooflights and openings of the file, from 0, over all rooms of a building. */
struct pp_text_edit {
    enum pp_text_edit_kind kind;
    int opening;
    struct pp_opening_place place;
};

/* Makes the edits, which must be sorted by opening. The text must be valid for
 * pp_building_parse. The caller frees *changed, which has *changed_length bytes and a
 * NUL. */
enum pp_status pp_room_text_edit(char **changed, size_t *changed_length,
                                 const char *text, size_t length,
                                 const struct pp_text_edit *edits, int edit_count,
                                 struct pp_error *err);

/* Puts `way` before the relative path of each file, for a room file that moves
 * (relative_path.h). The caller frees *moved. */
enum pp_status pp_room_text_move(char **moved, size_t *moved_length, const char *text,
                                 size_t length, const char *way, struct pp_error *err);

/* Element of the opening after the edit (PP_TEXT_SET or PP_TEXT_ADD), from "<" to ">";
 * freed by the caller. */
enum pp_status pp_room_text_element(char **element, const char *text, size_t length,
                                    const struct pp_text_edit *edit,
                                    struct pp_error *err);

#endif
