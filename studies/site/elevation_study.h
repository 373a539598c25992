/* elevation_study.h - elevations of the outer walls of a site's rooms that have
 * windows, with contours of the vertical sky component. */
#ifndef PP_STUDIES_SITE_ELEVATION_STUDY_H
#define PP_STUDIES_SITE_ELEVATION_STUDY_H

#include "model/results/sheets/site_sheet.h"
#include "studies/site/site_study.h"

/* Fills sheet, which the caller clears; empty on failure. A wall belongs to the
 * elevation of its direction, within 2 degrees; inner walls belong to none. The
 * components of a wall are those in its outer plane: that of its facade or, without
 * one, of its deepest reveal. Contours are accurate to 10 mm. PP_BAD_INPUT if there is
 * no vertical window. */
enum pp_status pp_elevation_study_make(struct pp_elevation_sheet *sheet,
                                       const struct pp_site_rooms *rooms,
                                       struct pp_error *err);

#endif
