/* exposure_point.h - the point of a window at which the hours of sun are counted, on the
 * inside of its wall. */
#ifndef PP_STUDIES_CRITERIA_WINDOWS_EXPOSURE_POINT_H
#define PP_STUDIES_CRITERIA_WINDOWS_EXPOSURE_POINT_H

#include "model/room/world.h"

/* Point at the middle of the opening's width. For a vertical opening, the point is at
 * least above_floor_m over the floor and above_sill_m over the sill, but no higher than
 * the head. For sloping glass, the point is the centre. */
struct pp_vec3 pp_exposure_point(const struct pp_opening *opening, double above_floor_m,
                                 double above_sill_m);

/* The same point at mid-height of the opening. */
struct pp_vec3 pp_exposure_point_centre(const struct pp_opening *opening);

#endif
