/* band_tree.h - finds the regimes of a sample: rooms and points are split so that the
 * bands become as narrow as possible.
 *
 * The search starts from given regimes. In each step one regime is split in two: the
 * one whose best split reduces the sum of interval scores most. The interval score of a
 * central interval of level 1 - alpha is its width plus 2/alpha times the distance of
 * rows outside it. The score is least for the true quantiles and the narrowest bands
 * [GR07] (eq. 43). The score is calculated for logarithms of ratios and summed over the
 * levels 0.5 and 0.8. The level 0.95 is not used, since it would select regimes that
 * have a narrow band by chance.
 */
#ifndef PP_STUDIES_BANDS_BAND_TREE_H
#define PP_STUDIES_BANDS_BAND_TREE_H

#include "studies/bands/band_sample.h"

struct pp_band_rules {
    int rooms_least; /* least number of rooms in a regime; splits into smaller regimes
                      * are rejected */
    int regimes_most;
    double gain_least; /* least reduction of the score by a split, as a fraction of the
                        * score of all rows */
};

/* Rules used for the program's table: at least 300 rooms per regime, at most 20
 * regimes, gain 0.4 %. With fewer rooms per regime, regimes would be selected whose
 * bands are narrow by chance. */
extern const struct pp_band_rules pp_band_tree_rules;

/* Finds the regimes; the caller frees the list. Each row of the sample is in exactly
 * one regime. Limits in conditions are rounded to two digits. Equal samples give equal
 * lists. begun: one to regimes_most initial regimes, with each row in exactly one; only
 * their conditions are used. A regime without conditions contains all rows. */
enum pp_status pp_band_tree_grow(struct pp_band_regime **regimes, int *count,
                                 const struct pp_band_sample *sample,
                                 const struct pp_band_rules *rules,
                                 const struct pp_band_regime *begun, int begun_count,
                                 struct pp_error *err);

/* Writes the indices of the sample's rows that are in a regime, in their order, to
 * `rows`, which has space for all rows. Returns their number. */
int pp_band_tree_rows(int *rows, const struct pp_band_sample *sample,
                      const struct pp_band_regime *regime);

#endif
