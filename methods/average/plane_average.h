/* plane_average.h - the mean of a quantity over a room's working plane, by adaptive
 * cubature of degree 7. */
#ifndef PP_METHODS_AVERAGE_PLANE_AVERAGE_H
#define PP_METHODS_AVERAGE_PLANE_AVERAGE_H

#include "model/base/crew.h"
#include "model/room/world.h"

enum { PP_PLANE_VALUES = 2 };

/* The values (not negative) at a point of the working plane, for a receiver that faces
 * up. Called from several threads at once; false stops the integration. */
typedef bool pp_plane_function(void *data, const struct pp_receiver *receiver,
                               double values[PP_PLANE_VALUES]);

/* mean[k] is the mean of values[k] over world->plane.
 *
 * The plane is divided into nine uneven rectangles or, unless it is one rectangle, into
 * triangles. A piece is refined until its estimated error is its part of
 * relative_error/8 times the sum of the integrals, or until it has had about
 * most_points over the number of pieces, as happens where something cuts the light off
 * sharply. In a rectangle the points are denser towards the walls. With a relative
 * error of 1e-3 and 2000 points, the sky component of 200 random boxes with a window
 * had an rms error of 5e-4, 95 of 100 within 1e-3, the worst 4e-3; of 60 L-shaped rooms
 * 1e-3 and 5e-3. The members of `crew` share the pieces; the points and the sum do not
 * depend on how many there are.
 *
 * *stopped tells whether the function has stopped the integration; the mean is then not
 * valid. Fails where the plane is empty (PP_BAD_INPUT) and for lack of memory. */
enum pp_status pp_plane_average(double mean[PP_PLANE_VALUES], bool *stopped,
                                const struct pp_world *world,
                                pp_plane_function *function, void *data,
                                double relative_error, int most_points,
                                struct pp_crew *crew, struct pp_error *err);

#endif
