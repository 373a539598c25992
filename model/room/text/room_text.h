/* room_text.h - the text of a room file with some of its windows changed, or moved to
 * another folder; all else stays byte for byte, comments and blanks included. */
#ifndef PP_MODEL_ROOM_TEXT_ROOM_TEXT_H
#define PP_MODEL_ROOM_TEXT_ROOM_TEXT_H

#include <stddef.h>

#include "model/base/error.h"
#include "model/room/room.h"

enum pp_text_edit_kind {
    PP_TEXT_SET,   /* the opening moves to the place given */
    PP_TEXT_ADD,   /* another opening like it, in that place, comes behind it */
    PP_TEXT_REMOVE /* the opening is left out */
};

/* One edit of the opening-th window, rooflight or opening of the file, from 0, over all
 * rooms of a building. Edits apply to windows and rooflights only. */
struct pp_text_edit {
    enum pp_text_edit_kind kind;
    int opening;
    struct pp_opening_place place;
};

/* The text, in which pp_building_parse has found no mistake, with the edits made; they
 * are in order of their openings. *changed is the caller's, *changed_length bytes and a
 * 0. */
enum pp_status pp_room_text_edit(char **changed, size_t *changed_length,
                                 const char *text, size_t length,
                                 const struct pp_text_edit *edits, int edit_count,
                                 struct pp_error *err);

/* Rewrites the text with `way` put before the relative path of each mesh, as described
 * in relative_path.h for a room file that moves. *moved is the caller's. */
enum pp_status pp_room_text_move(char **moved, size_t *moved_length, const char *text,
                                 size_t length, const char *way, struct pp_error *err);

/* Element of the opening after the edit (PP_TEXT_SET or PP_TEXT_ADD), from "<" to ">";
 * the caller's. */
enum pp_status pp_room_text_element(char **element, const char *text, size_t length,
                                    const struct pp_text_edit *edit,
                                    struct pp_error *err);

#endif
