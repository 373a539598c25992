/* view_grid.h - a grid for a fisheye picture: lines of altitude and azimuth, points of
 * the compass, and outlines of openings. */
#ifndef PP_STUDIES_PICTURES_VIEW_GRID_H
#define PP_STUDIES_PICTURES_VIEW_GRID_H

#include "model/pictures/camera.h"
#include "model/results/sheets/picture_sheet.h"
#include "model/room/world.h"

/* Adds circles of altitude every 15 degrees with their figures, lines of azimuth every
 * 30 degrees with points of the compass, and outlines of openings to the sheet.
 * Coordinates are pixels of the sheet's raster. The camera must be a fisheye. */
enum pp_status pp_view_grid(struct pp_picture_sheet *sheet,
                            const struct pp_camera *camera,
                            const struct pp_world *world, struct pp_error *err);

#endif
