/* gbxml_prism.h - the vertical prism over a space's floor, used if neither the surfaces
 * about it nor its ShellGeometry close. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_PRISM_H
#define PP_FORMATS_GBXML_GBXML_PRISM_H

#include "formats/gbxml/gbxml_shell.h"
#include "model/geometry/clipper.h"

/* Makes a prism over the floor of the space: its PlanarGeometry, or all level polygons
 * at the foot of its ShellGeometry together, or those of `count` more polygons, the
 * slabs of the lowest storey: the one whose area is nearest to the space's Area, or the
 * first without one. Of a floor of several pieces the largest is taken, without holes.
 * Its height is the space's Volume by its Area, or by the floor; without one, or with
 * one above all polygons, it ends at the lowest level polygon over half the floor, or
 * else as high as the walls that stand on it; not below lid_least_m (-INFINITY: any).
 * *why: as of pp_gbxml_shell_make. */
enum pp_status pp_gbxml_prism_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_space *space,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   double lid_least_m, struct pp_clipper *clipper,
                                   struct pp_error *err);

#endif
