/* view_grid.h - directions and outlines as a camera sees them, to lay over its picture.
 */
#ifndef PP_STUDIES_PICTURES_VIEW_GRID_H
#define PP_STUDIES_PICTURES_VIEW_GRID_H

#include "model/pictures/camera.h"
#include "model/results/picture_sheet.h"
#include "model/room/world.h"

/* Adds to the sheet circles of altitude every 15 degrees and lines of azimuth every 30,
 * the former with their figures, the latter with the points of the compass, and the
 * outlines of the openings as they are seen. Of a fisheye; the picture has the raster's
 * size. */
enum pp_status pp_view_grid(struct pp_picture_sheet *sheet,
                            const struct pp_camera *camera,
                            const struct pp_world *world, struct pp_error *err);

#endif
