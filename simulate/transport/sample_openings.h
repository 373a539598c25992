/* sample_openings.h - next-event estimation of a room's openings. Directions to an
 * opening are sampled as if it were a lamp that emits the light of sky, ground and
 * obstructions passing through it. Inside simulate/ only.
 *
 * All openings are sampled if there are at most four, or at the first surface of a
 * path. Otherwise one opening is chosen by importance. light_path.c adds the light
 * outside:
 *
 *     pp_sample_openings_begin(state, &shading, &sampling);
 *     while (pp_sample_openings_next(state, &sampling, &sample))
 *         ... sample.weight times the light that comes along sample.ray ...
 */
#ifndef PP_SIMULATE_TRANSPORT_SAMPLE_OPENINGS_H
#define PP_SIMULATE_TRANSPORT_SAMPLE_OPENINGS_H

#include "simulate/transport/path_vertex.h"

/* A direction to an opening, or to the mouth of its niche. */
struct pp_opening_sample {
    int opening;
    struct pp_light_ray ray; /* leaves the opening to the outside */
    struct pp_rgb weight;    /* BRDF times cosine times transmittance, divided by the
                              * density */
    struct pp_rgb sources; /* weighted light of emitters outside, such as the sun, that
                            * a pane scatters; not included in the light along ray */
    bool on_side;          /* true: the direction ends on a side of the niche, */
    struct pp_light_hit side; /* at this hit; the weight then contains no
                               * transmittance */
};

/* The directions to all openings that are sampled at one shading point. */
struct pp_opening_sampling {
    const struct pp_shading_point *shading; /* not owned */
    bool all;                               /* true: all openings in order; false:
                                             * one of them */
    int opening, end;                       /* present index, and end of the list */
    uint32_t direction, count;              /* present direction to that opening, and
                                             * their number */
    uint32_t index; /* the path's own index, restored in `state` at the end */
    int numbers;    /* random numbers of each direction: 2 for its position, 1 for the
                     * choice of an opening */
    bool drawn;     /* u holds the random numbers of all directions */
    double u[3][PP_RUN_MOST];
};

void pp_sample_openings_begin(struct pp_radiance_state *state,
                              const struct pp_shading_point *shading,
                              struct pp_opening_sampling *sampling);

/* Returns false at the end. While the function returns true, state->index is the index
 * of the direction. */
bool pp_sample_openings_next(struct pp_radiance_state *state,
                             struct pp_opening_sampling *sampling,
                             struct pp_opening_sample *sample);

/* Samples a direction to this opening by two numbers in (0, 1); false if no light
 * arrives along it. */
bool pp_sample_openings_aim(struct pp_radiance_state *state,
                            const struct pp_shading_point *shading, int opening,
                            const double u[2], struct pp_opening_sample *sample);

/* Evaluates a direction that was sampled elsewhere; false if the direction does not
 * reach this opening first. The weight is the transmittance alone. */
bool pp_sample_openings_along(struct pp_radiance_state *state,
                              const struct pp_shading_point *shading, int opening,
                              struct pp_vec3 to, struct pp_opening_sample *sample);

/* Multiplies the light of a sample by `by`, for a sample that is not on a side of a
 * niche. */
void pp_sample_openings_scale(struct pp_opening_sample *sample, struct pp_rgb by);

/* Vertex for the random numbers of events behind an opening. */
int pp_sample_openings_vertex(const struct pp_shading_point *shading, int opening);

/* Weight of light that the path's own ray has found at the inside of the opening: 0 if
 * next-event estimation includes the light, 1 if not, a value between for multiple
 * importance sampling. */
double pp_sample_openings_weight(struct pp_radiance_state *state,
                                 const struct pp_light_path *path, int opening);

#endif
