/* sample_bright.h - directions to the bright parts of a photographed sky, mixed with
 * directions of another density.
 *
 * One sample is drawn from both densities: with the probability q from that of the
 * bright parts, p_b (sky_bright.h), otherwise from the other density p. Its density is
 * then
 *
 *     q p_b(u) + (1 - q) p(u)
 *
 * for every u, which is the balance heuristic for one sample [VG95]. No light of the
 * sky is counted twice, and no further rays are needed. q is 1/16 if none of the
 * representative directions of the bright parts can contribute, and 1/2 if all can. If
 * the bright parts have less than half of the light, q is lower in proportion.
 */
#ifndef PP_SIMULATE_SAMPLING_SAMPLE_BRIGHT_H
#define PP_SIMULATE_SAMPLING_SAMPLE_BRIGHT_H

#include <stdbool.h>

#include "model/light/photographs/sky_bright.h"
#include "simulate/sampling/sample_polygon.h"

/* q for directions from the point `from`, on a surface with the normal n, to a
 * target. */
double pp_sample_bright_share_of_target(const struct pp_sky_bright *bright,
                                        const struct pp_target *target,
                                        struct pp_vec3 from, struct pp_vec3 n);

/* Draws a direction to the bright parts; false if it does not meet the target. */
bool pp_sample_bright_draw_to_target(const struct pp_sky_bright *bright,
                                     const struct pp_target *target,
                                     struct pp_vec3 from, double u, double v,
                                     struct pp_direction_sample *sample);

/* Draws a direction from the mixture with the cosine lobe about n, in the frame (a, b,
 * n). Returns the factor of the throughput: the density of the lobe over that of the
 * mixture. bright NULL: the lobe alone. */
double pp_sample_bright_lobe(const struct pp_sky_bright *bright, struct pp_vec3 a,
                             struct pp_vec3 b, struct pp_vec3 n, double u, double v,
                             struct pp_vec3 *to);

#endif
