/* light_bound.h - the most that the light which enters a room can give on average.
 *
 * Through an opening of glass area W = area x frame factor, with the transmittance tau and
 * the illuminance E on its outside (of Eh, from the open sky and from the ground), no more
 * than the flux
 *
 *     F = sum of W tau E                                                          (1)
 *
 * enters. Were all of it to fall on the working plane, of area S, at once, the average there
 * would be F / S: no direct component has a greater one. What is reflected comes back to
 * the plane at most once for each reflection, and a reflection leaves on average the share
 * R, the mean reflectance of all inside surfaces with openings of 0.1, by which light is
 * lost. So no component, nor their sum, is more on average than
 *
 *     F / S (1 + R + R^2 + ...) = F / (S (1 - R))                                 (2)
 *
 * With S in place of the area of all surfaces this is the integrating sphere's figure some
 * five times over, so that no figure of use comes near. split-flux reaches it where it
 * leaves out large openings between white surfaces: it has 1,046 % where light paths find
 * 26 % and (2) allows 262 %.
 */
#ifndef PP_METHODS_REFLECTED_LIGHT_BOUND_H
#define PP_METHODS_REFLECTED_LIGHT_BOUND_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

/* Averages over the working plane (fractions): of light that comes straight, and of any.
 * INFINITY where there is no bound: no working plane, or surfaces that give off light. */
struct pp_light_bound {
    double direct, any;
};

struct pp_light_bound pp_light_bound(const struct pp_world *world,
                                     const struct pp_outside_light *light);

#endif
