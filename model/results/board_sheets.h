/* board_sheets.h - data of Waldram and pepper-pot diagrams: the windows seen from a
 * point, and the counted squares or dots. */
#ifndef PP_MODEL_RESULTS_BOARD_SHEETS_H
#define PP_MODEL_RESULTS_BOARD_SHEETS_H

#include <stdbool.h>

#include "model/geometry/curve.h"
#include "model/geometry/region.h"
#include "model/light/sky.h"

/* ---- windows on a diagram ---- */

/* A counted square of the diagram. */
struct pp_counted_square {
    int column, row; /* position of the lower left corner */
    int tenths;      /* counted tenths of the square, 0 to 10 */
};

/* A visible piece of a window: sky, or an obstruction. */
struct pp_board_piece {
    struct pp_region outline; /* in coordinates of the diagram */
    bool hidden;              /* true for an obstruction */
    double factor;            /* luminance factor of the obstruction; 1 for the sky */
    double counted;           /* number of squares or dots in the piece */
    int square_count;
    struct pp_counted_square *squares; /* squares of the piece; NULL on a
                                       * pepper-pot diagram */
};

struct pp_board_window {
    const char *label; /* label of the opening, not owned */
    double distance_m; /* distance of the point from the opening's plane */
    double allowance;  /* factor for glass, frame and dirt */
    double sky,
        external; /* illuminance through the window, fractions of Eh, with allowance */
    int count;    /* number of pieces; 0: not visible from the point */
    struct pp_board_piece *pieces;
};

/* Face of the room that contains the windows of a panel; all zero: not named. */
struct pp_board_face {
    const char *name; /* NULL: no name; not owned */
    bool overhead;    /* a ceiling; else a wall */
};

/* Sets the members sky and external of the window from its counted squares or dots.
 * worth: value of one square or dot, fraction of Eh. */
void pp_board_sheets_window_sum(struct pp_board_window *window, double worth);

/* Adds the members sky and external of all windows to *sky and *external. */
void pp_board_sheets_windows_add(const struct pp_board_window *windows, int count,
                                 double *sky, double *external);

/* True if any of the windows has a piece hidden by an obstruction. */
bool pp_board_sheets_windows_hidden(const struct pp_board_window *windows, int count);

/* Extends the rectangle low, high to include all pieces. */
void pp_board_sheets_window_extent(const struct pp_board_window *window, double low[2],
                                   double high[2]);

void pp_board_sheets_windows_destroy(struct pp_board_window *windows, int count);

/* ---- Waldram diagram ----
 *
 * Lengths are in squares of the diagram. x is positive to the right of azimuth 0, the
 * direction normal to the window; y is measured upwards from the horizon. A method
 * fills the sheet (methods/waldram/waldram_sheet_fill.h); a chart draws it
 * (charts/drawing_board/waldram_chart.h).
 */

/* A diagram with all windows that face one direction. */
struct pp_waldram_panel {
    struct pp_board_face face;
    bool glazed;                   /* includes the losses of clear single vertical
                                    * glass */
    int low, high;                 /* columns from low to high - 1 are shown */
    double top;                    /* y of the zenith */
    double whole;                  /* value of the whole diagram, azimuth -90 to 90
                                    * degrees; fraction of Eh */
    double azimuth[181];           /* x by azimuth in whole degrees */
    double altitude[91];           /* y by altitude in whole degrees */
    struct pp_curve_list parallel; /* droop lines of horizontal edges parallel to the
                                    * window; level: altitude at azimuth 0, rad */
    struct pp_curve_list across;   /* droop lines of edges perpendicular to the
                                    * window; level: altitude approached at 90
                                    * degrees */
    int count;
    struct pp_board_window *windows;
};

struct pp_waldram_sheet {
    const char *name; /* name of the room, or NULL; not owned */
    bool blank;       /* blank diagram, without a room and a point */
    bool upright;     /* vertical receiver: `point` on the outside of a wall, at the
                   * centre of the window */
    struct pp_vec3 point;
    bool off_middle; /* true if `point` is not the window's centre */
    struct pp_sky sky;
    double worth;       /* value of a square, fraction of Eh */
    bool inclined;      /* `across` is for horizontal edges at an angle to the window
                         * in plan */
    double incline_rad; /* azimuth of the nearest point of such edges, positive to the
                         * right; valid if inclined */
    int count;
    struct pp_waldram_panel *panels;
    double sky_component, external; /* sums over all windows */
};

void pp_board_sheets_waldram_clear(struct pp_waldram_sheet *sheet);

/* ---- pepper-pot diagram ----
 *
 * Positions are in the window's plane at unit distance from the eye: (a, b) is a to the
 * right and b up. On paper they are multiplied by the viewing distance. A method fills
 * the sheet (methods/pepper_pot/pepper_pot_sheet_fill.h); a chart draws it
 * (charts/drawing_board/pepper_pot_chart.h).
 */

struct pp_pepper_pot_dot {
    double a, b;
    bool counted; /* inside a window */
};

/* A diagram with all windows that face one direction. */
struct pp_pepper_pot_panel {
    struct pp_board_face face;
    bool glazed;    /* includes the losses of clear single glass */
    bool any_slope; /* b is measured up the slope; else the windows are vertical */
    double whole;   /* value of all dots, fraction of Eh */
    int dot_count;
    struct pp_pepper_pot_dot *dots;
    int count;
    struct pp_board_window *windows;
};

struct pp_pepper_pot_sheet {
    const char *name; /* name of the room, or NULL; not owned */
    bool blank;       /* blank diagram, without a room and a point */
    bool upright;     /* vertical receiver */
    bool aslant;      /* sloping receiver; if neither is set, it faces up */
    bool any;         /* dots of method `pepper-pot-sky`, valid for any slope */
    struct pp_vec3 point;
    struct pp_sky sky;
    double worth; /* value of a dot, fraction of Eh */
    int count;
    struct pp_pepper_pot_panel *panels;
    double sky_component, external; /* sums over all windows */
};

void pp_board_sheets_pepper_pot_clear(struct pp_pepper_pot_sheet *sheet);

#endif
