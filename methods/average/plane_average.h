/* plane_average.h - the mean of a quantity over a room's working plane, by adaptive
 * cubature of degree 7. */
#ifndef PP_METHODS_AVERAGE_PLANE_AVERAGE_H
#define PP_METHODS_AVERAGE_PLANE_AVERAGE_H

#include "methods/average/plane_wedges.h"
#include "model/base/thread_pool.h"
#include "model/room/world.h"

enum { PP_PLANE_VALUES = 2 };

/* Light from one centre at a point of the working plane: values (not negative) for a
 * receiver that faces up. Called from several threads at once. Returning false stops
 * the integration. */
typedef bool pp_plane_function(void *data, int centre,
                               const struct pp_receiver *receiver,
                               double values[PP_PLANE_VALUES]);

/* mean[k] is the mean over world->plane of the sum of values[k] over the centres.
 *
 * Each centre's light is integrated in its own wedges (plane_wedges.h). Errors of up to
 * relative_error/8 times the sum of all integrals are allowed, divided among the
 * wedges. A wedge is refined until its estimated error is within its allowance, or
 * until about most_points points in it are evaluated. The wedges are divided among the
 * workers of `pool`; the points and the sum do not depend on the number of workers.
 *
 * *stopped: true if the function stopped the integration; mean is then undefined.
 * PP_BAD_INPUT if the room has no working plane. */
enum pp_status pp_plane_average(double mean[PP_PLANE_VALUES], bool *stopped,
                                const struct pp_world *world,
                                const struct pp_plane_centre *centres, int count,
                                pp_plane_function *function, void *data,
                                double relative_error, int most_points,
                                struct pp_thread_pool *pool, struct pp_error *err);

#endif
