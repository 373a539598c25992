/* gbxml_trim.h - adjacent rooms of one building: overlaps up to 20 mm are trimmed; of
 * two rooms with a larger overlap one is left out. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_TRIM_H
#define PP_FORMATS_GBXML_GBXML_TRIM_H

#include "formats/gbxml/gbxml_room.h"

/* Moves each face that extends up to 20 mm into an earlier room back to the face of
 * that room. rooms, spaces: `count` each. Notes moves of more than 5 mm. */
void pp_gbxml_trim_rooms(struct pp_gbxml_room *const *rooms,
                         struct pp_gbxml_space *const *spaces, int count,
                         struct pp_mistakes *notes);

/* Marks spaces as left_out, with a note, until no two rooms overlap. Each step removes
 * the room that overlaps the most others; of several such rooms, the smallest. */
enum pp_status pp_gbxml_trim_leave_out(struct pp_gbxml_room *const *rooms,
                                       struct pp_gbxml_space *const *spaces, int count,
                                       struct pp_mistakes *notes, struct pp_error *err);

#endif
