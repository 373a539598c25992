/* band_fit.h - the bands of a column: for the ratio of simulated to hand figures, and
 * for its two parts, which are due to the method's assumptions and to its formula.
 *
 * Regimes (band_tree.h) are those of the whole ratio. Each regime also has the bands of
 *
 *     formula      simulated value in the method's own world over the hand figure
 *     assumption   simulated value of the room over that in the method's world
 *
 * each with the offset of band_regime.h. A test on rooms that were not fitted passes if
 * in each regime the share of rooms differs from 95 % by at most three standard errors,
 *
 *     3 sqrt(0.95 0.05 (1 / n_fit + 1 / n_test))                                 (2)
 *
 * with n the number of rooms and not of points, as the errors of a room's points are
 * correlated.
 */
#ifndef PP_STUDIES_BANDS_BAND_FIT_H
#define PP_STUDIES_BANDS_BAND_FIT_H

#include "studies/bands/band_figures.h"
#include "studies/bands/band_tree.h"

/* Daylight factor below which bands are differences rather than ratios, a in (1) of
 * band_regime.h: ten times the accuracy of a simulated value. */
#define PP_BAND_OFFSET 2e-4

/* A regime and the bands of a column in it. */
struct pp_band_entry {
    struct pp_band_regime regime; /* its band is that of simulated to hand figures */
    double spread; /* half the distance between its quantiles of 16 and 84 % */
    struct pp_band_quantiles formula, assumption; /* NAN if the values in the method's
                                                   * own world are unknown */
};

/* The bands of a column, which the caller frees; none with fewer rooms than
 * rules->rooms_least. */
enum pp_status pp_band_fit(struct pp_band_entry **entries, int *count,
                           const struct pp_band_figures *figures,
                           const struct pp_band_rules *rules, struct pp_error *err);

/* Test of a band on rooms from which it was not made. */
struct pp_band_trial {
    struct pp_band_entry entry; /* from the rooms fitted */
    int rooms;                  /* tested */
    double inside;              /* share of the tested rooms' points in the band; NAN if
                                 * there are none */
    double between; /* `inside` without the band's ends; smaller if figures are exact
                     * in all digits, like figures of 0 */
    double limit;   /* largest permitted difference of `inside` from 0.95, from (2) */
};

/* Fits bands to one half of the rooms (band_figures.h) and tests them on the other.
 * *inside: share of all tested points inside their bands, over all regimes. The caller
 * frees the list. */
enum pp_status pp_band_fit_try(struct pp_band_trial **trials, int *count,
                               double *inside, const struct pp_band_figures *figures,
                               const struct pp_band_rules *rules, int side,
                               struct pp_error *err);

#endif
