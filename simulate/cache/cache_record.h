/* cache_record.h - calculates one irradiance record: hemisphere, derivatives, ellipse.
 * Inside simulate/ only.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_RECORD_H
#define PP_SIMULATE_CACHE_CACHE_RECORD_H

#include "simulate/cache/cache_hemisphere.h"

/* Settings of the records of one depth. */
struct pp_cache_record_settings {
    int side; /* side of the hemispheres */
    int supersamples;
    const struct pp_vec3 *corners; /* corners from cache_hemisphere.h; not owned */
    double error;                  /* bound of the error integrated over the ellipse,
                                    * relative to the value, m2 */
    double noise;                  /* standard error of a record's value, relative */
    double least_m, most_m;        /* radii */
};

/* state: the caller sets all but its index. cells: room for side^2. */
void pp_cache_record_compute(const struct pp_cache_record_settings *settings,
                             struct pp_radiance_state *state,
                             const struct pp_cache_place *place,
                             struct pp_cache_hemisphere_cell *cells,
                             struct pp_cache_entry *entry);

/* Ellipse of validity of a record, from its relative second derivatives aa, ab, bb
 * (1/m2) [SWJ12]:
 *
 *     R_i = (4 error / (pi |l_i|))^(1/4),
 *
 * l_i the eigenvalues: then the integral of the error over a disc of that radius is
 * `error`. The smaller radius comes first; axes as parts along a and b.
 *
 * The radius is then limited, in this order: at most most_m (here); the larger one at
 * most three times the smaller (here); the gradient changes the value by at most all of
 * it (pp_cache_record_compute); at least least_m (there); at most that of a neighbour
 * plus the distance to it (pp_cache_layer_add). */
void pp_cache_record_ellipse(const double curvature[3], double error, double most_m,
                             double radii_m[2], double axes[2][2]);

#endif
