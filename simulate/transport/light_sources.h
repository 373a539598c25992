/* light_sources.h - next-event estimation of concentrated emitters. Inside simulate/
 * only.
 *
 * An emitter is connected to the shading point directly, through clear surfaces, and by
 * plane mirrors (scene/images/mirrors.h). At the first surface of a path, every
 * connection is sampled, in several strata if the emitter has a large angular size. At
 * later surfaces, or if there are too many connections, one connection is chosen at
 * random by importance.
 */
#ifndef PP_SIMULATE_TRANSPORT_LIGHT_SOURCES_H
#define PP_SIMULATE_TRANSPORT_LIGHT_SOURCES_H

#include "simulate/transport/path_vertex.h"

/* One sample of the light from all concentrated emitters that the shading point sends
 * to the eye. */
struct pp_rgb pp_light_sources_next_event(struct pp_radiance_state *state,
                                          const struct pp_shading_point *shading);

/* Weight of light that the path's own ray has found at the emitter: 0 if next-event
 * estimation includes the light, 1 if not, a value between for multiple importance
 * sampling. */
double pp_light_sources_weight(const struct pp_radiance_state *state,
                               const struct pp_light_path *path, int emitter);

#endif
