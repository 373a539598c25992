/* path_scatter.h - BSDF sampling and Russian roulette at a vertex of a path. Inside
 * simulate/ only.
 */
#ifndef PP_SIMULATE_TRANSPORT_PATH_SCATTER_H
#define PP_SIMULATE_TRANSPORT_PATH_SCATTER_H

#include "simulate/transport/path_vertex.h"

/* Records a scattering surface in this space as the first surface of the path, if it is
 * the first. */
void pp_path_scatter_note_met(struct pp_light_path *path, enum pp_space space);

/* Russian roulette by the remaining throughput; true if the path continues. */
bool pp_path_scatter_survives(struct pp_light_path *path, double least, double u);

/* Chooses a lobe with a probability in proportion to its share; PP_LOBE_COUNT if all
 * lobes are black. Multiplies the throughput by the share divided by the
 * probability. */
enum pp_lobe pp_path_scatter_choose_lobe(const struct pp_lobes *lobes, double u,
                                         struct pp_rgb *throughput);

/* Sets the path's direction to a direction of the lobe, by two numbers in (0, 1). The
 * lobe's share is already in the throughput. False if the path ends. */
bool pp_path_scatter_by_lobe(const struct pp_radiance_state *state,
                             struct pp_light_path *path, const struct pp_lobes *lobes,
                             enum pp_lobe lobe, const struct pp_light_hit *hit,
                             double u, double v);

/* Sets the path's direction to a direction of a diffuse surface's cosine lobe, by the
 * random numbers of the path's vertex. False if Russian roulette, below the throughput
 * `least`, ends the path. Roulette ignores the weight of the direction, which is small
 * for a direction to a bright part of the sky. */
bool pp_path_scatter_diffuse(const struct pp_radiance_state *state,
                             struct pp_light_path *path, struct pp_vec3 from,
                             const struct pp_frame *frame, enum pp_space space,
                             double least);

#endif
