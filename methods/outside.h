/* outside.h - what the geometry of `exact` tells the other hand methods.
 *
 * Contract between `exact`, which answers, and `brs-table` and the obstruction angle,
 * which ask.
 */
#ifndef PP_METHODS_OUTSIDE_H
#define PP_METHODS_OUTSIDE_H

#include "model/world.h"

/* Illuminance over Eh that a plane through the middle of the opening's outline (its
 * centroid), with the unit normal `normal` towards the outside, gets from `sky` (not
 * the world's) where nothing outside hides it: for a vertical normal the vertical sky
 * component, sky only, without glass. Skylines of the opening's own face, blocks, loose
 * surfaces outside and the building's own outer faces hide. */
enum pp_status pp_outside_sky_on_plane(double *share, const struct pp_world *world,
                                       const struct pp_opening *opening,
                                       struct pp_vec3 normal, const struct pp_sky *sky,
                                       struct pp_error *err);

/* The part of the opening through which light from outside comes straight to
 * `position`: within both outlines and hidden by nothing inside the room. Drawn as seen
 * from there, on the plane at unit distance: x along opening->along, y along
 * opening->up, from the foot of the perpendicular, over the distance from the face's
 * plane. Not cut at the position's horizon. Empty if the position lies behind the
 * opening or in its plane. The region is the caller's. */
enum pp_status pp_outside_visible(struct pp_region *visible,
                                  const struct pp_world *world,
                                  const struct pp_opening *opening,
                                  struct pp_vec3 position, struct pp_error *err);

#endif
