/* gbxml_prism.h - a vertical prism over a space's floor, tried if neither its surfaces
 * nor its ShellGeometry give a closed envelope that matches Area and Volume. Inside
 * formats/gbxml/ only. */
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
 * this height is 1 m or less, or exceeds the height of the polygons by 3 % or more, the
 * prism ends at the lowest horizontal polygon that is more than 1 m above the lowest
 * corner and at least half as large as the floor, or else at the top of the walls on
 * the floor. The ceiling is not below lid_least_m (-INFINITY: no limit), unless all
 * polygons are. *why as in pp_gbxml_shell_make. */
enum pp_status pp_gbxml_prism_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_space *space,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   double lid_least_m, struct pp_clipper *clipper,
                                   struct pp_error *err);

#endif
