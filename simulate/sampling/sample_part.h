/* sample_part.h - directions through the part of a window behind which the openings of
 * a coarse model lie.
 *
 * From a point in a nested room, the sky is seen through the window and through an
 * opening of the coarse model beyond it, which may be small. Directions to the window
 * are therefore mixed with directions to the part of the window through which such
 * openings are seen, uniform in the area of the part. As in sample_bright.h, the
 * density of the mixture is known for every direction.
 */
#ifndef PP_SIMULATE_SAMPLING_SAMPLE_PART_H
#define PP_SIMULATE_SAMPLING_SAMPLE_PART_H

#include "simulate/sampling/sample_polygon.h"

/* The smallest rectangle with the central projections of the openings beyond. The share
 * is the smaller, the more of the window the part covers; 0 if no opening is seen. */
struct pp_seen_part pp_sample_part_of(const struct pp_target *target,
                                      struct pp_vec3 from,
                                      const struct pp_brightness *brightness);

/* A point of the part, by two numbers in (0, 1). */
struct pp_vec3 pp_sample_part_draw(const struct pp_polygon_sampler *sampler, double u,
                                   double v);

/* Density (1/m2) of pp_sample_part_draw at a point of the target. */
double pp_sample_part_density(const struct pp_polygon_sampler *sampler,
                              struct pp_vec3 point);

#endif
