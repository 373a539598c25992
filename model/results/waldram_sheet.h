/* waldram_sheet.h - what is to be seen on a sheet of Waldram's diagram, for whoever
 * draws it.
 *
 * All lengths on the diagram are in its squares, x from azimuth 0 (the direction square
 * to the window), positive to the right, y from the horizon up. A method fills it
 * (methods/waldram/waldram_sheet_fill.h); a chart draws it (charts/drawing_board/waldram_chart.h).
 */
#ifndef PP_MODEL_WALDRAM_SHEET_H
#define PP_MODEL_WALDRAM_SHEET_H

#include <stdbool.h>

#include "model/results/board_windows.h"
#include "model/geometry/curve.h"
#include "model/light/sky.h"

/* One diagram, with the windows that face one way. */
struct pp_waldram_panel {
    const char *wall;          /* that the windows are in, or NULL; not owned */
    bool glazed;               /* with the losses of clear single vertical glass */
    int low, high;             /* columns from low to high - 1 are shown */
    double top;                /* height of the zenith */
    double whole;              /* fraction of Eh from azimuth -90 to 90 degrees */
    double azimuth[181];       /* x of whole degrees */
    double altitude[91];       /* y of whole degrees */
    struct pp_curves parallel; /* droop lines of horizontal edges parallel to the
                                * window; level: altitude square to it, radians */
    struct pp_curves across;   /* of edges perpendicular to it; level: altitude
                                * that they approach at 90 degrees */
    int count;
    struct pp_board_window *windows;
};

struct pp_waldram_sheet {
    const char *name; /* the room's, or NULL; not owned */
    bool blank;       /* no room, no point */
    struct pp_vec3 point;
    struct pp_sky sky;
    double worth; /* of a square, fraction of Eh */
    int count;
    struct pp_waldram_panel *panels;
    double sky_component, external; /* of all windows */
};

void pp_waldram_sheet_clear(struct pp_waldram_sheet *sheet);

#endif
