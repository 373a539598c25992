/* read_elements.h - reads the elements of a room file into the parts of its rooms.
 * Inside model/room/ only. */
#ifndef PP_MODEL_ROOM_READ_READ_ELEMENTS_H
#define PP_MODEL_ROOM_READ_READ_ELEMENTS_H

#include "model/base/error.h"
#include "model/base/mistakes.h"
#include "model/base/xml.h"
#include "model/room/project.h"
#include "model/room/room_parts.h"

enum { PP_READ_ELEMENTS_BYTES_MOST = 8 << 20 }; /* largest room file */

/* XML format of room files: root elements and limits. */
extern const struct pp_xml_format pp_read_elements_format;

/* Contents of one file. */
struct pp_building {
    char *name; /* NULL: a single room, or not given */
    struct pp_room
        common; /* data common to all rooms: north (NAN: not given), site, sky,
                 * skylines, blocks, surfaces; no plan */
    double glass_reflectance; /* reflectance of the windows of placed rooms, as seen
                               * from other rooms; NAN: windows reflect like walls */
    struct pp_mirror_line boundary; /* line for the mirror image */
    struct pp_room *read; /* rooms as in the file; a room that stays unchanged is
                           * moved to `rooms` */
    int read_count;
    int *openings;         /* number of openings, by room of `read` */
    struct pp_room *rooms; /* rooms of the present state with their surroundings
                            * (building_site.h); NULL: not settled */
    int *places;           /* index in `read`, by room of `rooms` */
    bool *moved;           /* true if the room was moved from `read` */
    int room_count;
    unsigned states; /* states of all parts, as in pp_site_state_set */
    char *folder;    /* folder for relative paths, "" or with a final "/"; NULL: read
                   * from memory */
    struct pp_project project; /* owned texts */
    char *text;                /* the file, NUL-terminated */
    size_t text_length;
};

/* Fills the empty building from the file's elements. folder: base of relative paths;
 * NULL: read from memory. Returns PP_OK even if there are mistakes; fails only if
 * memory runs out. The caller destroys the building in any case. */
enum pp_status pp_read_elements(struct pp_building *building, const struct pp_xml *xml,
                                const char *folder, struct pp_mistakes *mistakes,
                                struct pp_error *err);

#endif
