/* cache_entry.h - a record as the cache keeps it, and the irradiance that it gives a
 * place near by. Inside simulate/ only.
 *
 * Its weight falls from 1 at its own place to 0 at the edge of its ellipse: where one
 * record takes over from another nothing jumps. It holds for places on the same side
 * only: facing alike, in the same space, not behind it, and with nothing standing
 * between: `horizon_m` is how far the surface is clear in each direction, by the lowest
 * rays of the hemisphere.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_ENTRY_H
#define PP_SIMULATE_CACHE_CACHE_ENTRY_H

#include "simulate/cache/irradiance_cache.h"

enum { PP_CACHE_SECTORS = 32 };

struct pp_cache_entry {
    struct pp_cache_record is;
    struct pp_vec3 a, b; /* the frame (a, b, normal) that sectors count about */
    double horizon_m[PP_CACHE_SECTORS];
    double along_noise; /* of the gradient, over that of the value, 1/m */
    double curvature;   /* greatest second derivative over the value, as far as it is
                         * sure to be more than noise, 1/m2 */

    /* Value in use: that of `is`, or the smoothed one (cache_smooth.h). */
    struct pp_rgb value;
    struct pp_vec3 along[3];
};

/* Value and gradients as the record has them. */
void pp_cache_entry_unsmooth(struct pp_cache_entry *entry);

/* Place of a request. */
struct pp_cache_place {
    struct pp_vec3 point, normal;
    enum pp_space space;
};

/* Distance of the place from the record, 0 at it and 1 at the edge of its ellipse; more
 * than 1e9 where it is more than `most`, and where the record does not hold for the place
 * however near. */
double pp_cache_entry_distance(const struct pp_cache_entry *entry,
                               const struct pp_cache_place *place, double most);

/* The irradiance there by the record's value and gradients, no channel below 0. */
struct pp_rgb pp_cache_entry_read(const struct pp_cache_entry *entry,
                                  const struct pp_cache_place *place);

/* The sector of a direction by its parts along a and b. */
int pp_cache_entry_sector(double along_a, double along_b);

#endif
