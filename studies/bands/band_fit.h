/* band_fit.h - the bands of a column: of what is true of the room, and of the method's
 * assumptions and its formula apart.
 *
 * Regimes are those of the whole (band_tree.h), truth over hand. In each of them stand
 * beside it
 *
 *     formula      what is true in the method's own world over the hand figure
 *     assumption   what is true of the room over what is true in that world
 *
 * each with the offset of band_regime.h. The bands hold for rooms that were not fitted as
 * far as the two samples allow: by regime their share of rooms differs from 95 % by no
 * more than three standard errors,
 *
 *     3 sqrt(0.95 0.05 (1 / n_fit + 1 / n_test))                                 (2)
 *
 * with n in rooms, as the points of a room err together: the share of a room's points
 * that lie inside varies by no more than that of one point.
 */
#ifndef PP_STUDIES_BANDS_BAND_FIT_H
#define PP_STUDIES_BANDS_BAND_FIT_H

#include "studies/bands/band_figures.h"
#include "studies/bands/band_tree.h"

/* Daylight factor below which bands are differences rather than ratios, a in (1) of
 * band_regime.h: ten times the accuracy of a simulated value. */
#define PP_BAND_OFFSET 2e-4

/* A regime with all that is known of a column in it. */
struct pp_band_entry {
    struct pp_band_regime regime; /* with the ratio of truth over hand */
    double spread; /* half the distance of its quantiles of 16 and 84 % */
    struct pp_band_quantiles formula, assumption; /* NAN where own is not known */
};

/* The entries of a column, to be freed. Of fewer rooms than rules->rooms_least there are
 * none. */
enum pp_status pp_band_fit(struct pp_band_entry **entries, int *count,
                           const struct pp_band_figures *figures,
                           const struct pp_band_rules *rules, struct pp_error *err);

/* Performance of a band on rooms that it was not made from. */
struct pp_band_trial {
    struct pp_band_entry entry; /* of the rooms fitted */
    int rooms;                  /* tested */
    double inside;              /* share of these in the band; NAN if there are none */
    double between; /* that share without the band's ends; it is smaller if figures are
                     * exact in all digits, like figures of 0 */
    double limit;   /* (2): how far from 0.95 that may be */
};

/* Fits the rooms of a side (band_figures.h) and tests the others. *inside: the share of
 * all tested rooms that are in the band, over all regimes. The caller frees the
 * list. */
enum pp_status pp_band_fit_try(struct pp_band_trial **trials, int *count,
                               double *inside, const struct pp_band_figures *figures,
                               const struct pp_band_rules *rules, int side,
                               struct pp_error *err);

#endif
