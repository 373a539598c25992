/* light_bound.h - an upper bound of a room's average, from the light that enters.
 *
 * Let an opening have the glass area W = area x frame factor, the transmittance tau and
 * the illuminance E on its outside (divided by Eh, from the open sky and from the
 * ground). At most the flux
 *
 *     F = sum of W tau E                                                          (1)
 *
 * enters. If all of it fell directly on the working plane, of area S, the average there
 * would be F / S: no direct component can have more. Reflected light returns to the
 * plane at most once for each reflection. On average, a reflection leaves the fraction
 * R, the mean reflectance of all inside surfaces (0.1 for openings). So the average of
 * any component, and of the sum of all components, is at most
 *
 *     F / S (1 + R + R^2 + ...) = F / (S (1 - R))                                 (2)
 *
 * The formula of the integrating sphere has the area of all surfaces in place of S, so
 * that (2) is about five times the result for the sphere. No realistic result comes
 * near this bound. split-flux exceeds the bound where it ignores large openings between
 * white surfaces. In one such case split-flux gives 1,046 %, where simulation gives 26
 * % and (2) allows 262 %.
 */
#ifndef PP_METHODS_REFLECTED_LIGHT_BOUND_H
#define PP_METHODS_REFLECTED_LIGHT_BOUND_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Upper bounds of averages over the working plane (fractions): of direct light, and of
 * all light. INFINITY if there is no bound: without a working plane, or with surfaces
 * that emit light. */
struct pp_light_bound {
    double direct, any;
};

struct pp_light_bound pp_light_bound(const struct pp_world *world,
                                     const struct pp_outside_light *light);

#endif
