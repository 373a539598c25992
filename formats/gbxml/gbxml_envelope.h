/* gbxml_envelope.h - the closed envelope that describes a space best, made from its
 * bounding surfaces, from its ShellGeometry, or as a prism over its floor. Inside
 * formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_ENVELOPE_H
#define PP_FORMATS_GBXML_GBXML_ENVELOPE_H

#include "formats/gbxml/gbxml_shell.h"
#include "model/base/mistakes.h"
#include "model/geometry/clipper.h"

/* Geometry from which an envelope can be made. */
struct pp_gbxml_envelope_parts {
    const struct pp_gbxml_space *space;
    const struct pp_gbxml_polygon *polygons; /* outlines of the bounding surfaces */
    int count;
    double openings_top_m; /* top of the highest opening; -INFINITY: no openings */
};

/* Tries, in this order: surfaces, ShellGeometry, prism. Corners are welded within 2 mm,
 * then within 20 mm if that changes the volume by at most 1 %. Planar holes are filled.
 * The first envelope within 3 % of the space's Area and Volume is used (a value missing
 * from the file is not compared). If there is none, the envelope with the smallest
 * deviation is used. An envelope with filled holes is used only if it deviates less
 * than those that close without. A prism does not replace an envelope with sloping
 * faces. Notes a source other than the surfaces, moves of more than 5 mm, filled holes,
 * and deviations of more than 3 %. *by_surfaces: true if the faces are the surfaces.
 * *why as in pp_gbxml_shell_make. */
enum pp_status pp_gbxml_envelope_make(struct pp_gbxml_shell *shell, const char **why,
                                      bool *by_surfaces,
                                      const struct pp_gbxml_envelope_parts *parts,
                                      struct pp_clipper *clipper,
                                      struct pp_mistakes *notes, struct pp_error *err);

#endif
