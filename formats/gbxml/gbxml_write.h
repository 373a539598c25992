/* gbxml_write.h - writes rooms and their surroundings as a room file. Inside
 * formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_WRITE_H
#define PP_FORMATS_GBXML_GBXML_WRITE_H

#include <stdio.h>

#include "formats/gbxml/gbxml_room.h"

/* Lines of the written file that describe one item of the gbXML file. An item whose
 * *left_out is set is not written the next time. */
struct pp_gbxml_written {
    int first, last; /* lines in the written file */
    int from;        /* line in the gbXML file */
    const char *what, *id;
    bool *left_out;
};

struct pp_gbxml_writing {
    FILE *out;
    int line; /* number of the next line, from 1 */
    struct pp_gbxml_written *items;
    int item_count;
};

/* Writes the building: surfaces for the shades and for the outer surfaces of spaces
 * without a room, then each room. rooms: one per space; NULL: no room. Fails only if
 * memory runs out. */
enum pp_status pp_gbxml_write(struct pp_gbxml_writing *writing,
                              struct pp_gbxml_model *model,
                              struct pp_gbxml_room *const *rooms, struct pp_error *err);

#endif
