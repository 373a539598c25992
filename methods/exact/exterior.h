/* exterior.h - the light on planes outside and the visible sky, by the geometry of
 * `exact`, for other methods and for criteria.
 */
#ifndef PP_METHODS_EXACT_EXTERIOR_H
#define PP_METHODS_EXACT_EXTERIOR_H

#include <stdbool.h>

#include "methods/exact/direct.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Centre of an opening's outside: the centroid of its outer outline or, if the pane is
 * set back from the facade, of the hole in the facade. A wall, however thick, therefore
 * does not obstruct its own windows. */
struct pp_vec3 pp_exterior_opening_centroid(const struct pp_opening *opening);

/* Illuminance over Eh, from the visible sky alone and without glass, of a plane through
 * the centre of the opening's outside with the outward unit normal `normal`. For a
 * horizontal normal it is the vertical sky component. Light from the ground is not
 * included. Obstructions are the skylines of the opening's own face, blocks,
 * free-standing surfaces outside and the building's own outer faces. */
enum pp_status pp_exterior_sky_on_plane(double *share, const struct pp_world *world,
                                        const struct pp_opening *opening,
                                        struct pp_vec3 normal, const struct pp_sky *sky,
                                        struct pp_error *err);

/* Illuminances of a plane, over Eh. */
struct pp_exterior_light {
    double sky;      /* from the sky alone */
    double external; /* from the ground and from obstructions: equivalent sky component
                      * times luminance factor, plus exitance */
};

/* Illuminances of a plane through any position outside, with unit normal `normal`.
 * `face` is the index of the surface in that plane. This surface hides nothing, and
 * only its skylines are included. -1: no such surface and no skylines. Closed form for
 * the overcast and uniform skies (errors of 1e-13), else quadrature to 1e-9. */
enum pp_status pp_exterior_light_on_plane(struct pp_exterior_light *outside,
                                          const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          struct pp_vec3 position,
                                          struct pp_vec3 normal, int face,
                                          struct pp_error *err);

/* As pp_exterior_light_on_plane, with the error bound and the tables of `how`. */
enum pp_status pp_exterior_light_within(struct pp_exterior_light *outside,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        struct pp_vec3 position, struct pp_vec3 normal,
                                        int face, const struct pp_direct *how,
                                        struct pp_error *err);

/* True if the illuminance is the same all over an opening's outside: in front of it are
 * only sky, ground and skylines without a distance. */
bool pp_exterior_is_uniform(const struct pp_world *world,
                            const struct pp_opening *opening);

/* Solid angle (sr) of the sky that is directly visible from a point in the room through
 * all its openings, whatever their glass; none through diffusing panes. Exactly 0 if no
 * sky is visible. */
enum pp_status pp_exterior_sky_solid_angle(double *solid_angle,
                                           const struct pp_world *world,
                                           struct pp_vec3 eye, struct pp_error *err);

#endif
