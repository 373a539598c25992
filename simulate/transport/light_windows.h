/* light_windows.h - next-event estimation of a room's openings: directions to a pane
 * are sampled as to a lamp, whose radiance is the light that sky, ground and whatever
 * stands outside send through it. Inside simulate/ only.
 */
#ifndef PP_SIMULATE_TRANSPORT_LIGHT_WINDOWS_H
#define PP_SIMULATE_TRANSPORT_LIGHT_WINDOWS_H

#include "simulate/transport/irradiance.h"
#include "simulate/transport/path_vertex.h"

/* One sample of the light that the shading point sends on to the eye from all windows,
 * added to sky and outside of *sum. */
void pp_light_windows_next_event(struct pp_radiance_state *state,
                                 const struct pp_shading_point *shading,
                                 struct pp_irradiance *sum);

/* Has the window been sampled directly from where the path's ray starts? */
bool pp_light_windows_directly_sampled(const struct pp_radiance_state *state,
                                       const struct pp_light_path *path, int window);

#endif
