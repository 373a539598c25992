/* meridians.h - an independent calculation of the direct component for tests, along
 * meridians.
 *
 * On the half-circle of directions with one azimuth, all positions of possible changes
 * are found as roots of the planes that cross it. Between two of them, one ray tested
 * against every object finds the visible one, and the integral is a sum of powers of
 * sine and cosine (or a quadrature, with glass or an ISO sky). Over azimuth, an
 * adaptive rule is used between the azimuths of all corners and crossings. It uses no
 * clipping, projection or overlay, and nothing of methods/.
 */
#ifndef PP_TESTS_LIB_MERIDIANS_H
#define PP_TESTS_LIB_MERIDIANS_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_meridian_sums {
    double sky, external;
};

/* Light of one opening of the world at the receiver, by the conventions of the program
 * but without its frame, dirt and curtains, to about relative_error. The rule over
 * azimuth starts with `parts` intervals between two corners; narrow features need
 * more. */
struct pp_meridian_sums pp_meridians(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     double relative_error, int parts);

#endif
