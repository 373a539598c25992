/* meridians.h - the direct component a second way, for tests: meridian by meridian.
 *
 * On the half-circle of directions of one azimuth, the places where anything can change
 * are found as roots of the planes that meet it; between two of them one ray, cast
 * against everything, says what is seen; what that gives is a sum of powers of sine and
 * cosine (or a quadrature, with glass or an ISO sky). Over azimuth, an adaptive rule
 * between the azimuths of all corners. Nothing is clipped, projected or overlaid, and
 * nothing of methods/ is used.
 */
#ifndef PP_TESTS_LIB_MERIDIANS_H
#define PP_TESTS_LIB_MERIDIANS_H

#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_meridian_sums {
    double sky, external;
};

/* Light of one opening of the world at the receiver, by the conventions, to about
 * relative_error; the rule over azimuth starts with `parts` to each stretch between two
 * corners: narrow features need more. */
struct pp_meridian_sums pp_meridians(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     double relative_error, int parts);

#endif
