/* band_sample.h - ratios of simulated value to hand value from an atlas, with their
 * features, and quantiles of the ratios.
 *
 * All points of a room together have a weight of 1, because their errors are
 * correlated. Rows of a room are adjacent.
 */
#ifndef PP_STUDIES_BANDS_BAND_SAMPLE_H
#define PP_STUDIES_BANDS_BAND_SAMPLE_H

#include "model/base/error.h"
#include "studies/bands/band_regime.h"

struct pp_band_sample {
    int count;              /* number of rows */
    const int *rooms;       /* number of the room of each row; rows of a room are
                             * adjacent */
    const double *ratios;   /* greater than 0 */
    int feature_count;      /* number of features in each row */
    const double *features; /* features of all rows, row after row */
};

/* Number of different rooms in `rows`, a list of `count` row indices in ascending
 * order. */
int pp_band_sample_rooms(const struct pp_band_sample *sample, const int *rows,
                         int count);

/* Quantiles of the ratios of rows (at least one). The rows of a room share its weight
 * of 1. 95 % of further rooms are expected between the outer quantiles. Among n rooms
 * these have rank 0.025 (n + 1) from either end; if n is less than 39, they are the
 * extremes. */
enum pp_status pp_band_sample_quantiles(struct pp_band_quantiles *quantiles,
                                        const struct pp_band_sample *sample,
                                        const int *rows, int count,
                                        struct pp_error *err);

/* Half the distance between the 16 % and 84 % quantiles: the standard deviation if the
 * ratios are normally distributed. */
enum pp_status pp_band_sample_spread(double *spread,
                                     const struct pp_band_sample *sample,
                                     const int *rows, int count, struct pp_error *err);

/* Fraction of rows, weighted as above, whose ratio is in the band. ends: include rows
 * exactly on an end of the band. */
double pp_band_sample_inside(const struct pp_band_sample *sample, const int *rows,
                             int count, const struct pp_band_quantiles *band,
                             bool ends);

#endif
