/* elevation_layers.h - distributes the outer walls of a site over elevations. */
#ifndef PP_STUDIES_SITE_ELEVATION_LAYERS_H
#define PP_STUDIES_SITE_ELEVATION_LAYERS_H

#include "model/base/error.h"
#include "model/results/sheets/site_sheet.h"
#include "studies/site/site_study.h"

/* Adds an elevation to the sheet for each direction that windows face, and assigns the
 * outer walls and windows to the elevations: walls get their room, face and distance
 * `front_m`, and nothing else. A wall with windows that would hide one behind it, or be
 * hidden, is on a separate elevation of the same direction, behind (`layer`). A wall without
 * windows is left out if it would hide another wall, or stands far from all walls with
 * windows. Requires the windows of the sheet. Elevations are clockwise from north, and
 * from front to back. PP_NO_MEMORY. */
enum pp_status pp_elevation_layers_make(struct pp_elevation_sheet *sheet,
                                        const struct pp_site_rooms *rooms,
                                        struct pp_error *err);

#endif
