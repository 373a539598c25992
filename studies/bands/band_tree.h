/* band_tree.h - the regimes of a sample, found by splitting rooms and points so that
 * the bands become as narrow as possible.
 *
 * In each step the regime whose best split reduces the sum of interval scores most is
 * split in two, starting from the given regimes. The interval score of a central
 * interval of level 1 - alpha is its width plus 2/alpha times the distance of rows
 * outside it; it is smallest for the right quantiles and the narrowest bands [GR07]
 * (eq. 43). It is calculated for logarithms of ratios and summed over the levels 0.5
 * and 0.8. The level 0.95 would select regimes that have a narrow band by chance: 5 of
 * 418 regimes were outside their limits on rooms held out, against 1 without it, with
 * bands 1 % wider.
 */
#ifndef PP_STUDIES_BANDS_BAND_TREE_H
#define PP_STUDIES_BANDS_BAND_TREE_H

#include "studies/bands/band_sample.h"

struct pp_band_rules {
    int rooms_least; /* least number of rooms in a regime; a split into smaller ones is
                      * rejected */
    int regimes_most;
    double gain_least; /* least reduction by a split, as a share of the score of all
                        * rows */
};

/* Rules of the program's table: 300 rooms, 20 regimes, 0.4 %. With 200 rooms, a regime
 * selected for its narrow band has too narrow a band: only 86.5 % of the rooms held out
 * were inside it. */
extern const struct pp_band_rules pp_band_tree_rules;

/* Grows the regimes as a list, freed by the caller; each row of the sample is in
 * exactly one. Bounds of conditions are rounded to two digits. The same sample gives
 * the same list. begun: one to regimes_most initial regimes, with each row in exactly
 * one; only their conditions are used. A regime without conditions has all rows. */
enum pp_status pp_band_tree_grow(struct pp_band_regime **regimes, int *count,
                                 const struct pp_band_sample *sample,
                                 const struct pp_band_rules *rules,
                                 const struct pp_band_regime *begun, int begun_count,
                                 struct pp_error *err);

/* Writes the rows of the sample in a regime, in their order, to `rows`, which has space
 * for all rows; returns their number. */
int pp_band_tree_rows(int *rows, const struct pp_band_sample *sample,
                      const struct pp_band_regime *regime);

#endif
