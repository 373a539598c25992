/* pepper_pot_plot.h - one panel of a pepper-pot diagram on paper.
 *
 * The eye is at the viewing distance v (mm) in front of the paper, at the height of the
 * horizon. A length of l metres in a vertical plane, d metres from the eye, is drawn
 * with the length
 *
 *     v l / d                                                        (mm)
 */
#ifndef PP_CHARTS_DRAWING_BOARD_PEPPER_POT_PLOT_H
#define PP_CHARTS_DRAWING_BOARD_PEPPER_POT_PLOT_H

#include "charts/sheet/lettering.h"
#include "charts/sheet/style.h"
#include "model/geometry/bounds.h"
#include "model/results/board_sheets.h"

struct pp_pepper_pot_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_pepper_pot_sheet *sheet;
    double viewing; /* distance from the eye to the paper, mm */
};

/* Extent of a panel's windows and the point straight ahead, as multiples of the
 * distance of their plane. Vertical panels extend at most 0.3 below the horizon. */
struct pp_bounds2 pp_pepper_pot_plot_extent(const struct pp_pepper_pot_panel *panel);

/* Frame of the panel within `room`, leaving space for its scales and text. */
struct pp_box pp_pepper_pot_plot_frame(const struct pp_pepper_pot_drawing *drawing,
                                       struct pp_box room);

/* Draws a panel of the sheet; `first` is the index of its first window, among those of
 * all panels. */
void pp_pepper_pot_plot_draw(const struct pp_pepper_pot_drawing *drawing,
                             const struct pp_pepper_pot_panel *panel, int first,
                             struct pp_box room);

#endif
