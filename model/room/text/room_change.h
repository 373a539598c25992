/* room_change.h - changes attributes in the text of a room file, by their address.
 *
 * An address is a path of parts, with an attribute at its end:
 *
 *     plan.depth                    the only plan
 *     window.W1.width               the window of that name
 *     window.2.width                the second window of its room
 *     window.width                  every window
 *     room.Kitchen.window.W1.width  in one room of a building
 *
 * A part is named by its `name`, its `ref` or its `wall`. Names may contain dots. A
 * part given by name or number must be unique.
 */
#ifndef PP_MODEL_ROOM_TEXT_ROOM_CHANGE_H
#define PP_MODEL_ROOM_TEXT_ROOM_CHANGE_H

#include <stdbool.h>
#include <stddef.h>

#include "model/base/error.h"

struct pp_room_change {
    const char *address; /* for example "window.W1.width" */
    const char *value;   /* new value, as in a file */
};

struct pp_room_changes {
    struct pp_room_change *list; /* applied in this order */
    int count;
    bool lenient; /* addresses that do not exist are ignored */
};

/* Applies the changes; everything else, including line breaks, stays byte for byte the
 * same. Text that is not well-formed is only copied, since the reader of room files
 * reports the mistakes. PP_BAD_INPUT for an address that does not exist, a name or
 * number that is not unique, or an attribute that the part cannot have. The caller
 * frees *changed, which has *changed_length bytes and a NUL. */
enum pp_status pp_room_change_text(char **changed, size_t *changed_length,
                                   const char *text, size_t length,
                                   const struct pp_room_changes *changes,
                                   struct pp_error *err);

#endif
