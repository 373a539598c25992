/* gbxml_loop.h - a PolyLoop of gbXML as a polygon in metres. Inside formats/gbxml/
 * only. */
#ifndef PP_FORMATS_GBXML_GBXML_LOOP_H
#define PP_FORMATS_GBXML_GBXML_LOOP_H

#include "formats/gbxml/gbxml_document.h"
#include "formats/gbxml/gbxml_model.h"
#include "model/geometry/clipper.h"

struct pp_gbxml_loop_reader {
    double metre;          /* metres of a unit of the file's lengths */
    struct pp_vec3 origin; /* which becomes (0, 0, 0); metres */
    struct pp_clipper *clipper;
    struct pp_mistakes *notes;
    struct pp_error *err;
};

/* Finds the origin: (0, 0, 0) for a model near it. A model more than 10 km away in plan
 * has coordinates of a national grid; its origin is then the lowest corner of its
 * surfaces, in whole metres, which is noted. */
void pp_gbxml_loop_find_origin(struct pp_gbxml_loop_reader *r,
                               const struct pp_xml_element *campus);

/* Reads a loop. An empty polygon, with a note, if it is none: fewer than three corners,
 * or corners without three coordinates or more than 100 km from the origin. An outline
 * that meets itself (two triangles in one, a wall joined to the rims of its holes)
 * becomes the outer rim of the figure that its crossings bound. Fails only without
 * memory. */
enum pp_status pp_gbxml_loop_read(struct pp_gbxml_polygon *polygon,
                                  struct pp_gbxml_loop_reader *r,
                                  const struct pp_xml_element *loop);

#endif
