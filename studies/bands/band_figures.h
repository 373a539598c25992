/* band_figures.h - figures of one column of an atlas with the simulated values, from
 * which its bands are fitted.
 *
 * A column is a component by a method, at points or of the average. Each row has the
 * hand figure, the simulated value in the world that the method assumes, the simulated
 * value of the room (all fractions, 0 or more), and features. Rows of a room are
 * adjacent.
 */
#ifndef PP_STUDIES_BANDS_BAND_FIGURES_H
#define PP_STUDIES_BANDS_BAND_FIGURES_H

#include "model/base/error.h"

/* Kind of place that a column's figures are for. */
enum pp_band_place { PP_BAND_POINT, PP_BAND_AVERAGE, PP_BAND_PLACES };
extern const char *const pp_band_figures_places[]; /* "point", "average" */

struct pp_band_figures {
    enum pp_band_place place;
    char component[8];
    char column[48];
    int count, capacity;
    int *rooms;
    double *hand, *own, *truth; /* own: NAN if unknown */
    int feature_count;          /* features of each row */
    double *features;           /* row after row */
};

/* Initialises an empty table for rows of this many features. */
void pp_band_figures_init(struct pp_band_figures *figures, int feature_count);
void pp_band_figures_clear(struct pp_band_figures *figures);

/* Data of one row to add. */
struct pp_band_row {
    int room;
    double hand, own, truth;
    const double *features;
};
enum pp_status pp_band_figures_add(struct pp_band_figures *figures,
                                   const struct pp_band_row *row, struct pp_error *err);

/* The half of the atlas, 0 or 1, to which a room belongs, from a hash of its number.
 * Even and odd numbers are not suitable: in a Sobol sequence they are in different
 * halves of the first dimension. */
int pp_band_figures_side(int room);

/* Adds the rows whose rooms are in that half. */
enum pp_status pp_band_figures_half(struct pp_band_figures *half,
                                    const struct pp_band_figures *figures, int side,
                                    struct pp_error *err);

#endif
