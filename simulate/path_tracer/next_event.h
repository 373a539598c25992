/* next_event.h - next-event estimation for path_trace.c: one direction to one of the room's
 * openings, and one to a lamp or the sun, at each diffuse surface of a path.
 *
 * Rays by which a mirror or a gloss reflects find that light themselves.
 */
#ifndef PP_SIMULATE_PATH_TRACER_NEXT_EVENT_H
#define PP_SIMULATE_PATH_TRACER_NEXT_EVENT_H

#include "simulate/path_tracer/path_trace.h"

/* One side of a surface that is lit. */
struct pp_lit_point {
    struct pp_vec3 point,
        normal; /* measured from the scene's centre; unit, of that side */
    enum pp_space space;
};

/* One sample of the irradiance through the openings. *first (may be NULL): by what the
 * light is first reflected outside, PP_FIRST_SKY if by nothing. */
struct pp_rgb pp_next_event_openings(struct pp_path_trace *path,
                                     const struct pp_lit_point *at,
                                     enum pp_path_first *first);

/* One sample of the irradiance by lamps and sun, through clear surfaces. */
struct pp_rgb pp_next_event_emitters(struct pp_path_trace *path,
                                     const struct pp_lit_point *at);

/* One sample of the radiance that the surface's diffuse lobes send towards the eye of
 * both, on either side. aims: of openings too? */
struct pp_rgb pp_next_event_reflected(struct pp_path_trace *path,
                                      const struct pp_lobes *lobes,
                                      const struct pp_light_hit *hit, bool aims);

/* The light that those have sampled for a ray which leaves by that lobe. space: of the
 * ray. */
struct pp_path_counted pp_next_event_counted(enum pp_lobe lobe, enum pp_space space,
                                             bool aims);

/* Leaves out of an opening's lobes those that go through it. */
void pp_next_event_leave_out(struct pp_lobes *lobes);

#endif
