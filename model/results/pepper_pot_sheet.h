/* pepper_pot_sheet.h - what is to be seen on a sheet of the pepper-pot diagram, for
 * whoever draws it.
 *
 * Places are in the window's plane at unit distance from the eye: (a, b) is seen a to
 * the right, b up, 1 ahead; on paper they are multiplied by the viewing distance. A
 * method fills it (methods/pepper_pot/pepper_pot_sheet_fill.h); a chart draws it
 * (charts/drawing_board/pepper_pot_chart.h).
 */
#ifndef PP_MODEL_PEPPER_POT_SHEET_H
#define PP_MODEL_PEPPER_POT_SHEET_H

#include <stdbool.h>

#include "model/results/board_windows.h"
#include "model/light/sky.h"

struct pp_pepper_pot_dot {
    double a, b;
    bool counted; /* in a window */
};

/* One diagram, with the windows that face one way. */
struct pp_pepper_pot_panel {
    const char *wall; /* that the windows are in, or NULL; not owned */
    bool glazed;      /* with the losses of clear single vertical glass */
    double whole;     /* all dots' worth together, fraction of Eh */
    int dot_count;
    struct pp_pepper_pot_dot *dots;
    int count;
    struct pp_board_window *windows;
};

struct pp_pepper_pot_sheet {
    const char *name; /* the room's, or NULL; not owned */
    bool blank;       /* no room, no point */
    bool upright;     /* is the receiver a vertical plane? else horizontal, face up */
    struct pp_vec3 point;
    struct pp_sky sky;
    double worth; /* of a dot, fraction of Eh */
    int count;
    struct pp_pepper_pot_panel *panels;
    double sky_component, external; /* of all windows */
};

void pp_pepper_pot_sheet_clear(struct pp_pepper_pot_sheet *sheet);

#endif
