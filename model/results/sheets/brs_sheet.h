/* brs_sheet.h - data of a printed BRS simplified daylight table: its cells, and the
 * readings for a point of a room. A method fills it (methods/brs/brs_sheet_fill.h); a
 * chart draws it (charts/drawing_board/brs_table_chart.h). */
#ifndef PP_MODEL_RESULTS_SHEETS_BRS_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_BRS_SHEET_H

#include <stdbool.h>

#include "model/geometry/vec.h"

enum { PP_BRS_ROWS = 29, PP_BRS_COLUMNS = 20 };

/* One reading from the table, for one corner of a rectangle. */
struct pp_brs_reading {
    int window;                /* index in the sheet's windows */
    bool hidden;               /* true for an obstruction, false for sky */
    bool lower, left;          /* true: lower edge; true: left jamb */
    int sign;                  /* +1 or -1 in the sum */
    double h_over_d, w_over_d; /* both above 0 */
    double row, column;        /* position of these values: 0 is the first row
                                * (infinity) and the first column (0.1); PP_BRS_ROWS
                                * and -1 where the table ends in zero */
    double value;              /* value read, a fraction of Eh */
    double factor;             /* luminance factor of the obstruction; 1 for sky */
};

struct pp_brs_window {
    const char *label; /* label of the opening, not owned */
    double distance_m;
    double allowance;     /* factor for glass, frame and dirt */
    double sky, external; /* fractions of Eh, including the allowance */
};

struct pp_brs_sheet {
    const char *name; /* name of the room, or NULL; not owned */
    bool blank;
    struct pp_vec3 point;
    double h_over_d[PP_BRS_ROWS], w_over_d[PP_BRS_COLUMNS]; /* as printed;
                                                             * h/d descends */
    double percent[PP_BRS_ROWS][PP_BRS_COLUMNS];            /* as printed */
    bool odd[PP_BRS_ROWS][PP_BRS_COLUMNS]; /* deviates unusually from the calculated
                                            * sky component (brs_odd_cells.csv) */
    struct pp_brs_window *windows;
    int window_count;
    struct pp_brs_reading *readings;
    int reading_count;
    double sky_component, external; /* sums over all windows */
};

void pp_brs_sheet_clear(struct pp_brs_sheet *sheet);

#endif
