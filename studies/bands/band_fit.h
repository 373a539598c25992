/* band_fit.h - fits the bands of a column: for the ratio of simulated values to values
 * by a hand method, and for its two parts, which are due to the method's assumptions
 * and to its formula.
 *
 * Regimes (band_tree.h) are chosen for the whole ratio. Each regime also has bands for
 * two further ratios:
 *
 *     formula      simulated value in the method's own world over the hand figure
 *     assumption   simulated value of the room over that in the method's world
 *
 * Each ratio has the offset of band_regime.h. The method's own world is the room as
 * simplified by the assumptions of the method. Bands are tested on rooms that were not
 * used in the fit. The test passes if in each regime the fraction of points inside the
 * band, in which each room has a total weight of 1, differs from 95 % by at most three
 * standard errors:
 *
 *     3 sqrt(0.95 0.05 (1 / n_fit + 1 / n_test))                                 (2)
 *
 * n is the number of rooms, not of points, because the errors at points of the same
 * room are correlated.
 */
#ifndef PP_STUDIES_BANDS_BAND_FIT_H
#define PP_STUDIES_BANDS_BAND_FIT_H

#include "studies/bands/band_figures.h"
#include "studies/bands/band_tree.h"

/* Offset a in (1) of band_regime.h. For daylight factors below the offset, bands are
 * differences rather than ratios. The offset is ten times the accuracy of a simulated
 * value. */
#define PP_BAND_OFFSET 2e-4

/* A regime and the bands of a column in it. */
struct pp_band_entry {
    struct pp_band_regime regime; /* its band is for the ratio of simulated value to
                                   * hand value */
    double spread; /* half the distance between the 16 % and 84 % quantiles of that
                    * ratio */
    struct pp_band_quantiles formula, assumption; /* NAN if the simulated values in the
                                                   * simplified room are unknown */
};

/* Fits the bands of a column. The caller frees the list. There are no bands if there
 * are fewer rooms than rules->rooms_least. */
enum pp_status pp_band_fit(struct pp_band_entry **entries, int *count,
                           const struct pp_band_figures *figures,
                           const struct pp_band_rules *rules, struct pp_error *err);

/* Test of a band on rooms that were not used to fit it. */
struct pp_band_trial {
    struct pp_band_entry entry; /* fitted to the other rooms */
    int rooms;                  /* number of rooms tested */
    double inside;              /* fraction of the tested points inside the band; NAN if
                                 * there are none */
    double between; /* `inside` without points exactly on an end of the band; smaller
                     * than `inside` if many values are exactly equal, such as 0 */
    double limit;   /* largest permitted difference between `inside` and 0.95, from
                     * (2) */
};

/* Fits bands to one half of the rooms (band_figures.h) and tests them on the other
 * half. *inside: fraction of all tested points inside their bands, over all regimes.
 * The caller frees *trials. */
enum pp_status pp_band_fit_try(struct pp_band_trial **trials, int *count,
                               double *inside, const struct pp_band_figures *figures,
                               const struct pp_band_rules *rules, int side,
                               struct pp_error *err);

#endif
