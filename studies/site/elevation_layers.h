/* elevation_layers.h - distributes the outer walls of a site over elevations. */
#ifndef PP_STUDIES_SITE_ELEVATION_LAYERS_H
#define PP_STUDIES_SITE_ELEVATION_LAYERS_H

#include "model/base/error.h"
#include "model/results/sheets/site_sheet.h"
#include "studies/site/site_study.h"

/* Adds an elevation to the sheet for each direction that windows face, and assigns
 * outer walls and windows to the elevations. For walls, only room, room_at, face and
 * front_m are set. A wall with windows that would hide another wall with windows, or be
 * hidden, is on a separate elevation of the same direction, on a layer farther back. A
 * wall without windows is omitted unless some elevation has a place for it: no wall
 * there overlaps it, and it is near a wall with windows or in the same room as a wall
 * there. The windows of the sheet must be set before. Elevations are in order clockwise
 * from north, and from front to back. PP_SYSTEM if memory is exhausted. */
enum pp_status pp_elevation_layers_make(struct pp_elevation_sheet *sheet,
                                        const struct pp_site_rooms *rooms,
                                        struct pp_error *err);

#endif
