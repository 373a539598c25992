/* gbxml_loop.h - a PolyLoop of gbXML as a polygon in metres. Inside formats/gbxml/
 * only. */
#ifndef PP_FORMATS_GBXML_GBXML_LOOP_H
#define PP_FORMATS_GBXML_GBXML_LOOP_H

#include "formats/gbxml/gbxml_document.h"
#include "formats/gbxml/gbxml_model.h"
#include "model/geometry/clipper.h"

struct pp_gbxml_loop_reader {
    double metre;          /* metres per length unit of the file */
    struct pp_vec3 origin; /* point of the file's axes that becomes (0, 0, 0); metres */
    struct pp_clipper *clipper;
    struct pp_mistakes *notes;
    struct pp_error *err;
};

/* Finds the origin: (0, 0, 0) for a model near it. A model more than 10 km away in plan
 * uses a national grid; its origin becomes the lowest corner of its surfaces, in whole
 * metres, with a note. */
void pp_gbxml_loop_find_origin(struct pp_gbxml_loop_reader *r,
                               const struct pp_xml_element *campus);

/* Reads a loop. The polygon is empty, with a note, if it has fewer than three corners,
 * or if a corner lacks a coordinate or is more than 100 km from the origin. An outline
 * that crosses or touches itself (two triangles in one, a wall joined to the outlines
 * of its holes) becomes the outer ring of its figure. Fails only if memory runs out. */
enum pp_status pp_gbxml_loop_read(struct pp_gbxml_polygon *polygon,
                                  struct pp_gbxml_loop_reader *r,
                                  const struct pp_xml_element *loop);

#endif
