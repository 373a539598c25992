/* cache_entry.h - a record in the form stored in the cache, and the irradiance that is
 * extrapolated from it to a nearby place. Inside simulate/ only.
 *
 * The weight of a record falls from 1 at its own place to 0 at the edge of its ellipse,
 * so that there is no jump between neighbouring records. The record is valid only for
 * places with a similar normal, in the same space, not behind the record's surface, and
 * without an obstacle in between. horizon_m is the distance to the next surface in each
 * direction, found by the lowest rays of the hemisphere.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_ENTRY_H
#define PP_SIMULATE_CACHE_CACHE_ENTRY_H

#include "simulate/cache/irradiance_cache.h"

enum { PP_CACHE_SECTORS = 32 };

struct pp_cache_entry {
    struct pp_cache_record is;
    struct pp_vec3 a, b; /* frame (a, b, normal); sectors are numbered by azimuth from
                          * a */
    double horizon_m[PP_CACHE_SECTORS];
    double along_noise; /* noise of the gradient divided by the noise of the value,
                         * 1/m */
    double curvature;   /* greatest second derivative less its possible noise, divided
                         * by the value, 1/m2 */

    /* Value in use: that of the record, or the smoothed one (cache_smooth.h). */
    struct pp_rgb value;
    struct pp_vec3 along[3];
};

/* Resets value and gradients to those of the record, without smoothing. */
void pp_cache_entry_unsmooth(struct pp_cache_entry *entry);

/* Place of a request. */
struct pp_cache_place {
    struct pp_vec3 point, normal;
    enum pp_space space;
};

/* Normalised distance of the place from the record: 0 at the record, 1 at the edge of
 * its ellipse. Above 1e9 if the distance exceeds `most`, or if the record is not valid
 * for the place at any distance. */
double pp_cache_entry_distance(const struct pp_cache_entry *entry,
                               const struct pp_cache_place *place, double most);

/* Irradiance at the place, extrapolated by the record's value and gradients; no channel
 * is below 0. */
struct pp_rgb pp_cache_entry_read(const struct pp_cache_entry *entry,
                                  const struct pp_cache_place *place);

/* The sector of a direction, from its components along a and b. */
int pp_cache_entry_sector(double along_a, double along_b);

#endif
