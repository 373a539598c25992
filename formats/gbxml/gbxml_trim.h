/* gbxml_trim.h - rooms of one building side by side: overlaps up to 20 mm are trimmed,
 * of two rooms that overlap more one is left out. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_TRIM_H
#define PP_FORMATS_GBXML_GBXML_TRIM_H

#include "formats/gbxml/gbxml_room.h"

/* Moves faces of rooms that reach up to 20 mm through a face of a room before them back
 * to it. rooms: `count`, of as many spaces. Notes moves of more than 5 mm. */
void pp_gbxml_trim_rooms(struct pp_gbxml_room *const *rooms,
                         struct pp_gbxml_space *const *spaces, int count,
                         struct pp_mistakes *notes);

/* Marks spaces, as left_out with a note, until no two of the rooms overlap: each time
 * the one that overlaps most others, of equal ones the smaller. */
enum pp_status pp_gbxml_trim_leave_out(struct pp_gbxml_room *const *rooms,
                                       struct pp_gbxml_space *const *spaces, int count,
                                       struct pp_mistakes *notes, struct pp_error *err);

#endif
