/* band_figures.h - the values of one column of an atlas, with the simulated values to
 * which they are compared in the fit of bands.
 *
 * A column is a component by a method, at points or for the average. Each row has three
 * values (fractions, 0 or more): by the hand method, simulated in the room as
 * simplified by the method's assumptions, and simulated in the room itself. Each row
 * also has features. Rows of a room are adjacent.
 */
#ifndef PP_STUDIES_BANDS_BAND_FIGURES_H
#define PP_STUDIES_BANDS_BAND_FIGURES_H

#include "model/base/error.h"

/* Kind of place to which the values of a column belong. */
enum pp_band_place { PP_BAND_POINT, PP_BAND_AVERAGE, PP_BAND_PLACES };
extern const char *const pp_band_figures_places[]; /* "point", "average" */

struct pp_band_figures {
    enum pp_band_place place;
    char component[8];
    char column[48];
    int count, capacity;
    int *rooms;
    double *hand, *own, *truth; /* own: simulated in the simplified room; NAN if
                                 * unknown */
    int feature_count;          /* number of features in each row */
    double *features;           /* features of all rows, row after row */
};

/* Initialises an empty table for rows with this number of features. */
void pp_band_figures_init(struct pp_band_figures *figures, int feature_count);
void pp_band_figures_clear(struct pp_band_figures *figures);

/* Data of a row to be added. */
struct pp_band_row {
    int room;
    double hand, own, truth;
    const double *features;
};
enum pp_status pp_band_figures_add(struct pp_band_figures *figures,
                                   const struct pp_band_row *row, struct pp_error *err);

/* Half of the atlas, 0 or 1, to which a room belongs, determined by a hash of its
 * number. Odd and even numbers would not be suitable, since in a Sobol sequence they
 * are in different halves of the first dimension. */
int pp_band_figures_side(int room);

/* Adds the rows whose rooms belong to that half. */
enum pp_status pp_band_figures_half(struct pp_band_figures *half,
                                    const struct pp_band_figures *figures, int side,
                                    struct pp_error *err);

#endif
