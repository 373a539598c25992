/* light_windows.h - next-event estimation of a room's openings: directions to a pane
 * are sampled as to a lamp, whose radiance is the light that sky, ground and whatever
 * stands outside send through it. Inside simulate/ only.
 *
 * Of up to four openings, and at the first surface of a path, all are sampled; of more,
 * one that is chosen by its importance. The light outside is for light_path.c to find:
 *
 *     pp_light_windows_begin(state, &shading, &sampling);
 *     while (pp_light_windows_next(state, &sampling, &sample))
 *         ... sample.weight times the light that comes along sample.ray ...
 */
#ifndef PP_SIMULATE_TRANSPORT_LIGHT_WINDOWS_H
#define PP_SIMULATE_TRANSPORT_LIGHT_WINDOWS_H

#include "simulate/transport/path_vertex.h"

/* A direction to a window, or to the mouth of its niche. */
struct pp_window_sample {
    int window;
    struct pp_light_ray ray;  /* leaves it to the outside */
    struct pp_rgb weight;     /* BRDF, cosine and transmittance over density */
    bool on_side;             /* it ends in the niche, */
    struct pp_light_hit side; /* here; no transmittance is in the weight then */
};

/* The directions to all windows that are sampled at one shading point. */
struct pp_window_sampling {
    const struct pp_shading_point *shading; /* not owned */
    bool all;                               /* windows one by one; else one of them */
    int window, end;                        /* the one in turn */
    uint32_t direction, count;              /* the one in turn, of that window's */
    uint32_t index; /* the path's own, which `state` has again at the end */
    int numbers;    /* random ones of each: 2 for its place, 1 for which window */
    bool drawn;     /* are the random numbers of all directions in u? */
    double u[3][PP_RUN_MOST];
};

void pp_light_windows_begin(struct pp_radiance_state *state,
                            const struct pp_shading_point *shading,
                            struct pp_window_sampling *sampling);

/* False at the end. While it is true state->index is the direction's own. */
bool pp_light_windows_next(struct pp_radiance_state *state,
                           struct pp_window_sampling *sampling,
                           struct pp_window_sample *sample);

/* One direction to that window, drawn by two numbers in (0, 1); false where no light
 * comes along it. */
bool pp_light_windows_aim(struct pp_radiance_state *state,
                          const struct pp_shading_point *shading, int window,
                          const double u[2], struct pp_window_sample *sample);

/* A direction that was drawn otherwise: false where it does not come to that window
 * first. The weight is the transmittance alone. */
bool pp_light_windows_along(struct pp_radiance_state *state,
                            const struct pp_shading_point *shading, int window,
                            struct pp_vec3 to, struct pp_window_sample *sample);

/* The vertex for the random numbers of what follows behind a window. */
int pp_light_windows_vertex(const struct pp_shading_point *shading, int window);

/* The weight of light that the path's own ray has found at the window, by its inside: 0
 * where next-event estimation has it, 1 where it has nothing of it. */
double pp_light_windows_weight(struct pp_radiance_state *state,
                               const struct pp_light_path *path, int window);

#endif
