/* read_elements.h - from the elements of a room file to the parts of its rooms. Inside
 * model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_ELEMENTS_H
#define PP_MODEL_ROOM_READ_READ_ELEMENTS_H

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/base/xml.h"
#include "model/room/project.h"
#include "model/room/room_parts.h"

enum { PP_READ_ELEMENTS_BYTES_MOST = 8 << 20 }; /* of a room file */

/* A room file as XML, with its limits. */
extern const struct pp_xml_format pp_read_elements_format;

/* The contents of one file. */
struct pp_building {
    char *name; /* NULL: a lone room, or not given */
    struct pp_room
        common; /* what holds for all rooms: north (NAN: not given), site, sky,
                            * skylines, blocks, surfaces; it has no plan */
    double glass_reflectance; /* of the windows of placed rooms, for the others; NAN: as
                               * walls */
    struct pp_mirror_line boundary; /* at which it is mirrored */
    struct pp_room *read; /* the rooms as the file has them, each by itself; those that
                           * nothing is added to or taken from have moved to `rooms` */
    int read_count;
    int *openings;         /* how many each of these has */
    struct pp_room *rooms; /* those that there are in a state, with all that stands
                            * outside of each (building_site.h); NULL: not settled */
    int *places;           /* of each where it stands in `read`, */
    bool *moved;           /* and has it moved from there? */
    int room_count;
    bool has_states; /* something stands there in one state only */
    char *folder; /* that its paths are relative to, "" or with a / behind it; NULL: it
                      * was in memory */
    struct pp_project project; /* owned texts */
    char *text;                /* of the file, with a 0 behind it */
    size_t text_length;
};

/* Fills building, which is empty, from the file's elements; folder is what its paths are
 * relative to, NULL: it is in memory. PP_OK also where there are
 * mistakes; fails when memory is out. Either way the caller destroys the building. */
enum pp_status pp_read_elements(struct pp_building *building, const struct pp_xml *xml,
                                const char *folder, struct pp_mistakes *mistakes,
                                struct pp_error *err);

#endif
