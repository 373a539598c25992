/* gbxml_openings.h - the openings of a space in the faces of its room. Inside
 * formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_OPENINGS_H
#define PP_FORMATS_GBXML_GBXML_OPENINGS_H

#include "formats/gbxml/gbxml_room.h"
#include "model/geometry/clipper.h"

/* Adds the openings of the surfaces between the space and the outside to its finished
 * room. Each opening is projected onto the parallel faces within 0.6 m, nearest first,
 * and cut at their edges and at larger openings of the same face. Lost areas are
 * noted. */
enum pp_status pp_gbxml_openings_add(struct pp_gbxml_room *room,
                                     struct pp_gbxml_model *model,
                                     const struct pp_gbxml_space *space,
                                     struct pp_clipper *clipper,
                                     struct pp_mistakes *notes, struct pp_error *err);

#endif
