/* gbxml_prism.h - a vertical prism over a space's floor, used if neither its surfaces
 * nor its ShellGeometry give a closed envelope. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_PRISM_H
#define PP_FORMATS_GBXML_GBXML_PRISM_H

#include "formats/gbxml/gbxml_shell.h"
#include "model/geometry/clipper.h"

/* Makes a prism over the floor of the space.
 *
 * Candidates for the floor: the PlanarGeometry; the lowest horizontal polygons of the
 * ShellGeometry; the lowest horizontal polygons among the `count` given ones. The
 * candidate whose area is nearest to the space's Area is used; without an Area, the
 * first one. If the floor has several pieces, only the largest is used, without holes.
 *
 * The height is Volume divided by Area, or by the floor's area. Without a Volume, or if
 * this height is above all polygons, the prism ends at the lowest horizontal polygon
 * larger than half the floor, or else at the top of the walls on the floor. The ceiling
 * is at lid_least_m or higher (-INFINITY: no limit). *why as in pp_gbxml_shell_make. */
enum pp_status pp_gbxml_prism_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_space *space,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   double lid_least_m, struct pp_clipper *clipper,
                                   struct pp_error *err);

#endif
