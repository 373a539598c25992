/* path_openings.h - next-event estimation of a room's openings, in the tracer.
 *
 * An opening is chosen by its importance, a direction to it sampled (sample_polygon.h),
 * and the light outside in that direction followed. Inside simulate/ only.
 */
#ifndef PP_SIMULATE_TRACER_PATH_OPENINGS_H
#define PP_SIMULATE_TRACER_PATH_OPENINGS_H

#include "simulate/tracer/path_ray.h"

/* One sample of the irradiance by the openings at a point of a surface in the room,
 * times `throughput`, added to the component's part of `light`. u: place in the opening
 * (2) and the choice of it. */
void pp_path_openings(struct pp_path_state *state, struct pp_vec3 p, struct pp_vec3 n,
                      const double u[3], int vertex, double throughput, int component,
                      struct pp_light *light);

#endif
