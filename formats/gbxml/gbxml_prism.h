/* gbxml_prism.h - the vertical prism over a space's floor, used if neither the surfaces
 * about it nor its ShellGeometry close. Inside formats/gbxml/ only. */
#ifndef PP_FORMATS_GBXML_GBXML_PRISM_H
#define PP_FORMATS_GBXML_GBXML_PRISM_H

#include "formats/gbxml/gbxml_shell.h"

/* Makes a prism over the space's PlanarGeometry, or else over the largest level polygon
 * at the foot of its ShellGeometry and of `count` more polygons. The prism rises to the
 * highest corner of those. *why: as of pp_gbxml_shell_make. */
enum pp_status pp_gbxml_prism_make(struct pp_gbxml_shell *shell, const char **why,
                                   const struct pp_gbxml_space *space,
                                   const struct pp_gbxml_polygon *polygons, int count,
                                   struct pp_error *err);

#endif
