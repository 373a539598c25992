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

/* Sets r->origin. It is (0, 0, 0) for a model within 10 km of that point in plan. A
 * model farther away is assumed to use a national grid: its origin is the minimum of x,
 * y and z over its surfaces, in whole metres, with a note. Corners more than 50 km from
 * the first one do not count. */
void pp_gbxml_loop_find_origin(struct pp_gbxml_loop_reader *r,
                               const struct pp_xml_element *campus);

/* Reads a loop. The polygon is empty, with a note, if it has fewer than 3 or more than
 * 1000 corners, or if a corner lacks a coordinate or has one of more than 100 km,
 * measured from the origin. An outline may cross or touch itself (two triangles in one,
 * a wall joined to the outlines of its holes); it is replaced by the outer ring of its
 * largest piece. Fails only if memory runs out. */
enum pp_status pp_gbxml_loop_read(struct pp_gbxml_polygon *polygon,
                                  struct pp_gbxml_loop_reader *r,
                                  const struct pp_xml_element *loop);

#endif
