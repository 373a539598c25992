/* environment.h - what the geometry of `exact` tells the other hand methods.
 *
 * Contract between `exact`, which answers, and `brs-table` and the obstruction angle,
 * which ask.
 */
#ifndef PP_METHODS_VIEW_EXTERIOR_H
#define PP_METHODS_VIEW_EXTERIOR_H

#include <stdbool.h>

#include "model/room/world.h"

/* The middle of an opening on its outside: the centroid of the outer outline. */
struct pp_vec3 pp_exterior_opening_centroid(const struct pp_opening *opening);

/* Illuminance over Eh that a plane through the middle of the opening's outline (its
 * centroid), with the unit normal `normal` towards the outside, gets from `sky` (not
 * the world's) where nothing outside hides it: for a vertical normal the vertical sky
 * component, sky only, without glass. Skylines of the opening's own face, blocks, loose
 * surfaces outside and the building's own outer faces hide. */
enum pp_status pp_exterior_sky_on_plane(double *share, const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 normal, const struct pp_sky *sky,
                                        struct pp_error *err);

/* Illuminances of a plane, over Eh. */
struct pp_exterior_light {
    double sky;      /* from the sky alone */
    double external; /* from what hides it (equivalent sky component times luminance
                      * factor, and exitance) and from the ground */
};

/* What falls on a plane through any position outside, with unit normal `normal`; what
 * lies behind it does not count. `face` is the surface that the plane is part of, by
 * index: it hides nothing, and its skylines are those that count; -1: none and none.
 * Closed form for the overcast and uniform skies (errors of 1e-13), else quadrature to
 * 1e-9. */
enum pp_status pp_exterior_light_on_plane(struct pp_exterior_light *outside,
                                          const struct pp_world *world,
                                          const struct pp_sky *sky,
                                          struct pp_vec3 position,
                                          struct pp_vec3 normal, int face,
                                          struct pp_error *err);

/* Does the same fall on all of an opening's outside: is there nothing before it but
 * sky, ground and skylines without a distance? */
bool pp_exterior_is_uniform(const struct pp_world *world,
                            const struct pp_opening *opening);

/* Solid angle (sr) of the sky that is seen directly from a point in the room through
 * all its openings, whatever their glass; diffusing panes show none. Exactly 0 where
 * there is none. */
enum pp_status pp_exterior_sky_solid_angle(double *solid_angle,
                                           const struct pp_world *world,
                                           struct pp_vec3 eye, struct pp_error *err);

/* The part of the opening through which light from outside comes straight to
 * `position`: within both outlines and hidden by nothing inside the room. Drawn as seen
 * from there, on the plane at unit distance: x along opening->along, y along
 * opening->up, from the foot of the perpendicular, over the distance from the face's
 * plane. Not cut at the position's horizon. Empty if the position lies behind the
 * opening or in its plane. The region is the caller's. */
enum pp_status pp_exterior_visible_part(struct pp_region *visible,
                                        const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 position, struct pp_error *err);

#endif
