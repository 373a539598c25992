/* band_sample.h - ratios of true to hand figures with their features, as they come out of
 * an atlas, and their quantiles.
 *
 * The unit is the room: a room's points count together as one, as they err together. Rows
 * of one room stand together.
 */
#ifndef PP_STUDIES_BANDS_BAND_SAMPLE_H
#define PP_STUDIES_BANDS_BAND_SAMPLE_H

#include "model/base/error.h"
#include "studies/bands/band_regime.h"

struct pp_band_sample {
    int count;              /* of rows */
    const int *rooms;       /* the room of each row; rows of a room stand together */
    const double *ratios;   /* greater than 0 */
    int feature_count;      /* of each row */
    const double *features; /* row after row */
};

/* Number of rooms among rows, a list of `count` rows in rising order. */
int pp_band_sample_rooms(const struct pp_band_sample *sample, const int *rows,
                         int count);

/* The quantiles of the ratios of rows (at least one), each room of weight 1 that its rows
 * share. The outer ones stand where the expected share of further rooms between them is
 * 95 %: at the rank 0.025 (n + 1) of n rooms and as far from the other end, or at the ends
 * where n is under 39. */
enum pp_status pp_band_sample_quantiles(struct pp_band_quantiles *quantiles,
                                        const struct pp_band_sample *sample,
                                        const int *rows, int count,
                                        struct pp_error *err);

/* Half the distance of the quantiles of 16 and 84 %: the standard deviation, were the
 * ratios normal. */
enum pp_status pp_band_sample_spread(double *spread,
                                     const struct pp_band_sample *sample,
                                     const int *rows, int count, struct pp_error *err);

/* Share of rows, weighted as above, whose ratio lies in the band, with its ends or
 * without. */
double pp_band_sample_inside(const struct pp_band_sample *sample, const int *rows,
                             int count, const struct pp_band_quantiles *band,
                             bool ends);

#endif
