/* band_sample.h - ratios of simulated to hand figures with their features, from an
 * atlas, and their quantiles.
 *
 * The unit is the room: its points together have weight 1, as their errors are
 * correlated. Rows of one room are adjacent.
 */
#ifndef PP_STUDIES_BANDS_BAND_SAMPLE_H
#define PP_STUDIES_BANDS_BAND_SAMPLE_H

#include "model/base/error.h"
#include "studies/bands/band_regime.h"

struct pp_band_sample {
    int count;              /* number of rows */
    const int *rooms;       /* the room of each row; rows of a room are adjacent */
    const double *ratios;   /* greater than 0 */
    int feature_count;      /* features of each row */
    const double *features; /* row after row */
};

/* Number of rooms among rows, a list of `count` rows in rising order. */
int pp_band_sample_rooms(const struct pp_band_sample *sample, const int *rows,
                         int count);

/* Quantiles of the ratios of rows (at least one); the rows of a room share its weight
 * of 1. Between the outer quantiles 95 % of further rooms are expected: they are at
 * the rank 0.025 (n + 1) of n rooms from either end, or at the ends where n is under
 * 39. */
enum pp_status pp_band_sample_quantiles(struct pp_band_quantiles *quantiles,
                                        const struct pp_band_sample *sample,
                                        const int *rows, int count,
                                        struct pp_error *err);

/* Half the distance between the quantiles of 16 and 84 %: the standard deviation if the
 * ratios are normally distributed. */
enum pp_status pp_band_sample_spread(double *spread,
                                     const struct pp_band_sample *sample,
                                     const int *rows, int count, struct pp_error *err);

/* Share of rows, weighted as above, whose ratio lies in the band, with or without the
 * band's ends. */
double pp_band_sample_inside(const struct pp_band_sample *sample, const int *rows,
                             int count, const struct pp_band_quantiles *band,
                             bool ends);

#endif
