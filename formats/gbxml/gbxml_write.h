/* gbxml_write.h - writes rooms and their surroundings as a room file. Inside
 * formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_WRITE_H
#define PP_FORMATS_GBXML_GBXML_WRITE_H

#include <stdio.h>

#include "formats/gbxml/gbxml_room.h"

/* Source of a range of lines in the written file; setting its `left_out` removes it. */
struct pp_gbxml_written {
    int first, last; /* lines */
    int from;        /* the line of the gbXML file */
    const char *what, *id;
    bool *left_out;
};

struct pp_gbxml_writing {
    FILE *out;
    int line; /* that is written next, from 1 */
    struct pp_gbxml_written *items;
    int item_count;
};

/* Writes the building: a room for each that is not NULL (one a space), surfaces for the shades,
 * and for the outside of spaces without a room. Fails when memory is out. */
enum pp_status pp_gbxml_write(struct pp_gbxml_writing *writing,
                              struct pp_gbxml_model *model,
                              struct pp_gbxml_room *const *rooms, struct pp_error *err);

#endif
