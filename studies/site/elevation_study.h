/* elevation_study.h - elevations of the outer walls with windows of a site's rooms,
 * with contours of the vertical sky component. */
#ifndef PP_STUDIES_SITE_ELEVATION_STUDY_H
#define PP_STUDIES_SITE_ELEVATION_STUDY_H

#include "model/results/sheets/site_sheet.h"
#include "studies/site/site_study.h"

/* Makes the elevations. The caller clears *sheet, which is empty after a failure. A
 * wall belongs to the elevation of its direction, within 2 degrees; internal walls do
 * not belong to any. The vertical sky component is calculated in the outer plane of the
 * wall: that of the facade, or, if there is none, of the deepest reveal. Contours are
 * accurate to 10 mm. PP_BAD_INPUT if there is no vertical window, or if the meshes
 * outside a room have more than 2000 triangles. */
enum pp_status pp_elevation_study_make(struct pp_elevation_sheet *sheet,
                                       const struct pp_site_rooms *rooms,
                                       struct pp_error *err);

#endif
