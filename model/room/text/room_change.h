/* room_change.h - the text of a room file with attributes changed by their address.
 *
 * An address is a path of parts, with an attribute at its end:
 *
 *     plan.depth                    the only plan
 *     window.W1.width               the window of that name
 *     window.2.width                the second window of its room
 *     window.width                  every window
 *     room.Kitchen.window.W1.width  in one room of a building
 *
 * A part is named by its `name` or `ref`; a part without these by its `wall`. Names may
 * contain points. A part with a name or number must be a single one.
 */
#ifndef PP_MODEL_ROOM_TEXT_ROOM_CHANGE_H
#define PP_MODEL_ROOM_TEXT_ROOM_CHANGE_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

struct pp_room_change {
    const char *address; /* "window.W1.width" */
    const char *value;   /* of the attribute, as in a file */
};

struct pp_room_changes {
    struct pp_room_change *list; /* made one after the other */
    int count;
    bool lenient; /* an address that the file does not have is left out */
};

/* The text with the changes; all else stays, byte for byte, and so do the lines. A text
 * that is not well-formed is copied: its reader reports the mistakes. PP_BAD_INPUT for an
 * address that is not in the file, or an attribute that its part cannot have. *changed is
 * the caller's, *changed_length bytes and a 0. */
enum pp_status pp_room_change_text(char **changed, size_t *changed_length,
                                   const char *text, size_t length,
                                   const struct pp_room_changes *changes,
                                   struct pp_error *err);

#endif
