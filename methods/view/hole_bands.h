/* hole_bands.h - what a facade hides of an opening that stands back from it, as upright
 * rectangles round its hole. */
#ifndef PP_METHODS_VIEW_HOLE_BANDS_H
#define PP_METHODS_VIEW_HOLE_BANDS_H

#include "methods/view/elevation.h"
#include "model/geometry/frame.h"

/* Fills in the bands to the left, to the right, above and below the hole's extent, each
 * with the facade's reflectance and as far as anything goes, and returns how many there
 * are: 4, or 0 where nothing is hidden. Axes: x along the opening, y out through it. */
int pp_hole_bands(struct pp_elevation_part bands[4], const struct pp_world *world,
                  const struct pp_opening *opening, struct pp_vec3 point,
                  const struct pp_frame *axes);

#endif
