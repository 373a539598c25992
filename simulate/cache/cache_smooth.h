/* cache_smooth.h - noise reduction by fitting records to their neighbours.
 *
 * A record is calculated from a few hundred rays. Its value has a random error of a few
 * per cent. Its gradient adds error over the radius, more so if surfaces are near.
 * Without smoothing, records show as faint discs, mainly in dark rooms and in corners.
 * But the irradiance is smooth over an ellipse, so neighbours contain information about
 * a record's value and gradient. Each record is fitted, by weighted least squares, to
 * its own estimate and to its neighbours' values,
 *
 *     (E - E0)^2 + (grad E - grad E0)^2/g^2 + (noise M grad E)^2
 *     + sum of w (E + grad E . d - E')^2
 *
 *     w = 1/(1 + (c/noise)^2),  c = C d^2/2
 *
 *   E0     the record's own irradiance, E' a neighbour's, at distance d
 *   g      ratio of the noise of the record's gradient to the noise of its value
 *   M      the largest radius; light may change by 100 % over M, hardly by more
 *   C      the record's curvature, less the noise of its rays
 *   c      possible relative departure of light from its tangent at the distance d
 *
 * Neighbours have no weight where light changes quickly, or where their surroundings
 * are entirely different.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_SMOOTH_H
#define PP_SIMULATE_CACHE_CACHE_SMOOTH_H

#include "model/base/thread_pool.h"
#include "simulate/cache/cache_layer.h"

/* Fits all records of the layer to their neighbours, from the values before
 * smoothing. */
enum pp_status pp_cache_smooth_layer(struct pp_cache_layer *layer,
                                     struct pp_thread_pool *pool, struct pp_error *err);

#endif
