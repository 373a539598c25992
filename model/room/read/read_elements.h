/* read_elements.h - from the elements of a room file to the parts of its rooms. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_ELEMENTS_H
#define PP_MODEL_ROOM_READ_READ_ELEMENTS_H

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/room/room_parts.h"
#include "model/room/read/xml.h"

/* The contents of one file. */
struct pp_building {
    char *name; /* NULL: a lone room, or not given */
    struct pp_room *rooms;
    int room_count;
    char *text; /* of the file, with a 0 behind it */
    size_t text_length;
};

/* Fills building, which is empty, from the file's elements. PP_OK also where there are
 * mistakes; fails when memory is out. Either way the caller destroys the building. */
enum pp_status pp_read_elements(struct pp_building *building, const struct pp_xml *xml,
                                struct pp_mistakes *mistakes, struct pp_error *err);

#endif
