/* board_sheets.h - the data of the drawing board's sheets, Waldram's diagram and the
 * pepper-pot: the windows seen from a point, and their counts. */
#ifndef PP_MODEL_RESULTS_BOARD_SHEETS_H
#define PP_MODEL_RESULTS_BOARD_SHEETS_H

#include <stdbool.h>

#include "model/geometry/curve.h"
#include "model/geometry/region.h"
#include "model/light/sky.h"

/* ---- windows on a diagram ---- */

/* A square as it was counted. */
struct pp_counted_square {
    int column, row; /* its lower left corner */
    int tenths;      /* 0 to 10 */
};

/* A piece of a window through which one sees sky, or an obstruction. */
struct pp_board_piece {
    struct pp_region outline; /* in the diagram's own coordinates */
    bool hidden;              /* by an obstruction? */
    double factor;            /* luminance factor of the obstruction; 1 for the sky */
    double counted;           /* squares or dots within */
    int square_count;
    struct pp_counted_square *squares; /* all squares; NULL for dots */
};

struct pp_board_window {
    const char *label; /* of the opening, not owned */
    double distance_m; /* from the point to its plane */
    double allowance;  /* for its glass, frame and dirt */
    double sky,
        external; /* illuminance through it, fractions of Eh, allowance included */
    int count;    /* 0: the point sees nothing of it */
    struct pp_board_piece *pieces;
};

/* The face of the room that a panel's windows are in; all zero: it is not named. */
struct pp_board_face {
    const char *name; /* NULL where it has none; not owned */
    bool overhead;    /* is it a ceiling? else a wall */
};

/* Sets the window's sky and external from its counted squares or dots; `worth` is that
 * of one, a fraction of Eh. */
void pp_board_sheets_window_sum(struct pp_board_window *window, double worth);

/* Adds the windows' sky and external to *sky and *external. */
void pp_board_sheets_windows_add(const struct pp_board_window *windows, int count,
                                 double *sky, double *external);

/* True if an obstruction hides a piece of any of them. */
bool pp_board_sheets_windows_hidden(const struct pp_board_window *windows, int count);

/* The rectangle around all pieces, joined to the one given. */
void pp_board_sheets_window_extent(const struct pp_board_window *window, double low[2],
                                   double high[2]);

void pp_board_sheets_windows_destroy(struct pp_board_window *windows, int count);

/* ---- Waldram's diagram ----
 *
 * All lengths on the diagram are in its squares, x from azimuth 0 (the direction square
 * to the window), positive to the right, y from the horizon up. A method fills it
 * (methods/waldram/waldram_sheet_fill.h); a chart draws it
 * (charts/drawing_board/waldram_chart.h). */

/* One diagram with the windows that face one direction. */
struct pp_waldram_panel {
    struct pp_board_face face;
    bool glazed;                   /* with the losses of clear single vertical glass */
    int low, high;                 /* columns from low to high - 1 are shown */
    double top;                    /* height of the zenith */
    double whole;                  /* fraction of Eh from azimuth -90 to 90 degrees */
    double azimuth[181];           /* x of whole degrees */
    double altitude[91];           /* y of whole degrees */
    struct pp_curve_list parallel; /* droop lines of horizontal edges parallel to the
                                * window; level: altitude square to it, radians */
    struct pp_curve_list across;   /* of edges perpendicular to it; level: altitude
                                * that they approach at 90 degrees */
    int count;
    struct pp_board_window *windows;
};

struct pp_waldram_sheet {
    const char *name; /* the room's, or NULL; not owned */
    bool blank;       /* no room, no point */
    bool upright; /* for a wall's outside, at `point`: the one window's middle there */
    struct pp_vec3 point;
    bool off_middle; /* is that point not the middle of a window of a site? */
    struct pp_sky sky;
    double worth;       /* of a square, fraction of Eh */
    bool inclined;      /* are `across` the lines of edges that are inclined in plan, */
    double incline_rad; /* by that angle? */
    int count;
    struct pp_waldram_panel *panels;
    double sky_component, external; /* of all windows */
};

void pp_board_sheets_waldram_clear(struct pp_waldram_sheet *sheet);

/* ---- the pepper-pot diagram ----
 *
 * Places are in the window's plane at unit distance from the eye: (a, b) is seen a to
 * the right, b up, 1 ahead; on paper they are multiplied by the viewing distance. A
 * method fills it (methods/pepper_pot/pepper_pot_sheet_fill.h); a chart draws it
 * (charts/drawing_board/pepper_pot_chart.h). */

struct pp_pepper_pot_dot {
    double a, b;
    bool counted; /* in a window */
};

/* One diagram with the windows that face one direction. */
struct pp_pepper_pot_panel {
    struct pp_board_face face;
    bool glazed;    /* with the losses of clear single glass */
    bool any_slope; /* b is up the slope; else the windows are vertical */
    double whole;   /* all dots' worth together, fraction of Eh */
    int dot_count;
    struct pp_pepper_pot_dot *dots;
    int count;
    struct pp_board_window *windows;
};

struct pp_pepper_pot_sheet {
    const char *name; /* the room's, or NULL; not owned */
    bool blank;       /* no room, no point */
    bool upright;     /* is the receiver a vertical plane? else horizontal, face up */
    bool aslant;      /* or neither? */
    bool any;         /* the dots are those of `pepper-pot-sky`, for any slope */
    struct pp_vec3 point;
    struct pp_sky sky;
    double worth; /* of a dot, fraction of Eh */
    int count;
    struct pp_pepper_pot_panel *panels;
    double sky_component, external; /* of all windows */
};

void pp_board_sheets_pepper_pot_clear(struct pp_pepper_pot_sheet *sheet);

#endif
