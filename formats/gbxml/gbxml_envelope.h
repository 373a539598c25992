/* gbxml_envelope.h - the closed envelope that describes a space best: by the surfaces
 * about it, by its ShellGeometry, or a prism over its floor. Inside formats/gbxml/
 * only. */
#ifndef PP_FORMATS_GBXML_GBXML_ENVELOPE_H
#define PP_FORMATS_GBXML_GBXML_ENVELOPE_H

#include "formats/gbxml/gbxml_shell.h"
#include "model/base/mistakes.h"
#include "model/geometry/clipper.h"

/* Source of an envelope. */
struct pp_gbxml_envelope_parts {
    const struct pp_gbxml_space *space;
    const struct pp_gbxml_polygon *polygons; /* of the surfaces about it */
    int count;
    double openings_top_m; /* of the openings in them; -INFINITY: none */
};

/* Tries the surfaces, then the ShellGeometry, each with corners welded within 2 mm and
 * then within 20 mm where that changes the volume by 1 % at most, closed and then with
 * plane holes filled, then the prism. The first is taken whose floor area and volume are
 * within 3 % of the space's Area and Volume, as far as these are given; else the one
 * that is least off. A prism does not replace an envelope with slopes. Notes the choice,
 * moves of more than 5 mm, and differences of more than 3 %. *by_surfaces: the faces
 * are the surfaces'. *why as of pp_gbxml_shell_make. */
enum pp_status pp_gbxml_envelope_make(struct pp_gbxml_shell *shell, const char **why,
                                      bool *by_surfaces,
                                      const struct pp_gbxml_envelope_parts *parts,
                                      struct pp_clipper *clipper,
                                      struct pp_mistakes *notes, struct pp_error *err);

#endif
