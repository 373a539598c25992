/* band_tree.h - the regimes of a sample: found by splitting rooms and points where it
 * narrows the bands most.
 *
 * Begun with the regimes given, that one is split in two, again and again, whose best split
 * lowers the sum of the interval scores of the logarithms of ratios by most. The interval
 * score of a central interval of level 1 - alpha is its width, and 2/alpha times how far
 * rows lie outside, so that it is least for the right quantiles and the narrowest bands
 * [GR07] (eq. 43); it is summed over the levels 0.5 and 0.8.
 * With that of 0.95 regimes are chosen that have a narrow band by chance: of 418 then 5 lay
 * outside their limits on rooms held out, and 1 without it, with bands 1 % wider.
 */
#ifndef PP_STUDIES_BANDS_BAND_TREE_H
#define PP_STUDIES_BANDS_BAND_TREE_H

#include "studies/bands/band_sample.h"

struct pp_band_rules {
    int rooms_least; /* of a regime; splits that leave fewer are not made */
    int regimes_most;
    double gain_least; /* share of the score of all rows that a split has to save */
};

/* Rules of the program's table: 300 rooms, 20 regimes, 0.4 %. With 200 rooms, a regime
 * selected for its narrow band has too narrow a band: only 86.5 % of the rooms held out
 * were in one. */
extern const struct pp_band_rules pp_band_tree_rules;

/* Grows the regimes as a list, freed by the caller; each row of the sample is in
 * exactly one. Bounds of conditions are rounded to two digits. The same sample gives
 * the same list. begun: one to regimes_most initial regimes, with each row in exactly
 * one, of which only the conditions count; a regime without conditions has all rows. */
enum pp_status pp_band_tree_grow(struct pp_band_regime **regimes, int *count,
                                 const struct pp_band_sample *sample,
                                 const struct pp_band_rules *rules,
                                 const struct pp_band_regime *begun, int begun_count,
                                 struct pp_error *err);

/* The rows of the sample in a regime, in their order, in `rows` with space for all;
 * returns how many. */
int pp_band_tree_rows(int *rows, const struct pp_band_sample *sample,
                      const struct pp_band_regime *regime);

#endif
