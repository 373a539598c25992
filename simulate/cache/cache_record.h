/* cache_record.h - calculates one irradiance record: hemisphere, derivatives, ellipse.
 * Inside simulate/ only.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_RECORD_H
#define PP_SIMULATE_CACHE_CACHE_RECORD_H

#include "simulate/cache/cache_hemisphere.h"

/* Settings of the records of one depth. */
struct pp_cache_record_settings {
    int side; /* a hemisphere has side x side cells */
    int supersamples;
    const struct pp_vec3 *corners; /* corners from cache_hemisphere.h; not owned */
    double error;                  /* bound of the error, relative to the value,
                                    * integrated over the ellipse, m2 */
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
 *     R_i = (4 error / (pi |l_i|))^(1/4)
 *
 * with the eigenvalues l_i, so that the integral of the error over a disc of radius R_i
 * is `error`. radii_m[0] is the smaller radius; the axes are components along a and b.
 *
 * The radii are limited in this order. This function limits both to most_m, and the
 * larger radius to three times the smaller one. pp_cache_record_compute limits the
 * change of the value by the gradient to 100 %, and raises radii to at least least_m.
 * pp_cache_layer_add limits a radius to a neighbour's radius plus the distance to that
 * neighbour.
 */
void pp_cache_record_ellipse(const double curvature[3], double error, double most_m,
                             double radii_m[2], double axes[2][2]);

#endif
