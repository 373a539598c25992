/* waldram_squares.h - counts squares on a Waldram diagram [WW23].
 *
 * The diagram is ruled into squares of equal worth (0.1 % of Eh): columns of equal
 * width from azimuth -90 to 90 degrees, and rows from the horizon up, the last of which
 * may be cut off by the zenith. Whole squares within a window's outline count one, part
 * squares are estimated to a tenth. The rounding error of each estimate is added to the
 * next square, up a column and from column to column, so that counts have no bias.
 */
#ifndef PP_METHODS_WALDRAM_WALDRAM_SQUARES_H
#define PP_METHODS_WALDRAM_WALDRAM_SQUARES_H

#include "methods/waldram/waldram_scale.h"

#define PP_WALDRAM_WORTH 0.001    /* worth of a fine square */
enum { PP_WALDRAM_COLUMNS = 36 }; /* in 180 degrees: five degrees each without glass */

/* One square that the outline covers at least in part. */
struct pp_waldram_square {
    int column, row;  /* column from azimuth 0 (negative to the left), row from the
                       * horizon */
    double part;      /* exact fraction of the square's area that is covered */
    double estimated; /* as counted: tenths, 0 to 1 */
};

struct pp_waldram_count {
    double squares;                 /* the sum of the estimates */
    struct pp_waldram_square *list; /* column by column, from the horizon up */
    int count;
};

/* Width of a square in X and its height in Y. */
void pp_waldram_squares_size(const struct pp_waldram *waldram, double *width,
                             double *height);

/* Counts the squares of a region of a window's drawing (as for pp_waldram_scale_area).
 * The caller clears *count; empty on failure. */
enum pp_status pp_waldram_squares_count(struct pp_waldram_count *count,
                                        const struct pp_waldram *waldram,
                                        const struct pp_window_axes *axes,
                                        const struct pp_region *region,
                                        struct pp_error *err);
/* Counts the squares of a region on the diagram, in X and Y. */
enum pp_status pp_waldram_squares_count_outline(struct pp_waldram_count *count,
                                                const struct pp_waldram *waldram,
                                                const struct pp_region *outline,
                                                struct pp_error *err);
void pp_waldram_squares_clear(struct pp_waldram_count *count);

/* The region's outline on the diagram, in X and Y: droop lines as chords that deviate
 * by less than 0.003 squares. Not cut at +-90 degrees; points below the horizon are
 * moved up to the horizon. The caller clears the outline. */
enum pp_status pp_waldram_squares_outline(struct pp_region *outline,
                                          const struct pp_waldram *waldram,
                                          const struct pp_window_axes *axes,
                                          const struct pp_region *region,
                                          struct pp_error *err);

#endif
