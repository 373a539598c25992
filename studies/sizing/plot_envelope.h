/* plot_envelope.h - the largest building envelope on a plot with which all windows
 * around it keep the required amount of sky (retained_sky.h).
 *
 * As in building codes, each window has a plane that rises over the plot. The plane
 * begins at the centre of the window, at height z_i, and slopes upwards away from the
 * wall. The envelope is the space below all planes, divided into cells (plot_cells.h).
 * Each cell is as high as the planes allow at the corner nearest to the window:
 *
 *     h(cell) = min over i of  z_i + s tan(a_i) max(d_i, 0) - base
 *
 *     d_i  distance of the cell in front of the wall of window i; the window sets no
 *          limit for cells behind that wall
 *     a_i  altitude of the plane of window i with which the window just keeps its
 *          required value, if no other plane limits the cells
 *     s    1 or more: the greatest common factor with which every window keeps its
 *          required value
 *
 * At least one window then has exactly its required value. This envelope is the largest
 * one of this family, but not the largest possible, since there is no largest envelope
 * of arbitrary shape: if a window sees a tower straight ahead at the altitude g, an
 * extra metre on the tower hides, apart from a constant factor,
 *
 *     (1 + 2 sin g) cos^4 g        of the overcast sky
 *
 * which decreases above 17 degrees. The greatest volume would therefore consist of thin
 * towers of unlimited height.
 */
#ifndef PP_STUDIES_SIZING_PLOT_ENVELOPE_H
#define PP_STUDIES_SIZING_PLOT_ENVELOPE_H

#include "studies/sizing/plot_cells.h"
#include "studies/sizing/retained_sky.h"

struct pp_plot_envelope_task {
    struct pp_building
        *building;     /* building whose state and block are changed by the search:
                        * cells replace the block */
    const char *block; /* name of the block whose footprint is the plot */
    struct pp_retained_sky_rule rule; /* rule for the vertical sky component */
    double most_m;                    /* greatest height of a cell */
};

enum pp_plot_envelope_verdict {
    PP_PLOT_ENVELOPE_FOUND,
    PP_PLOT_ENVELOPE_ANY, /* all requirements are met even if all cells are most_m
                           * high */
    PP_PLOT_ENVELOPE_NONE /* a requirement is not met even without a building */
};

struct pp_plot_envelope {
    enum pp_plot_envelope_verdict verdict;
    struct pp_plot_cells cells; /* height_m is 0 if nothing can be built on a cell */
    double volume_m3;
    struct pp_retained_sky retained;
    double *altitudes_rad; /* altitudes of the planes, atan(s tan a_i), for each window;
                            * INFINITY: the window sets no limit; NAN: no result;
                            * owned */
    double factor;         /* factor s */
    int deciding;          /* index of the window with the least surplus; -1: none was
                   * assessed */
};

/* Finds the envelope. PP_BAD_INPUT if no window is assessed, the plot has no cell, or a
 * room is invalid with the objects on the plot. The caller clears *found, also after a
 * failure. */
enum pp_status pp_plot_envelope_find(struct pp_plot_envelope *found,
                                     const struct pp_plot_envelope_task *task,
                                     struct pp_error *err);
void pp_plot_envelope_clear(struct pp_plot_envelope *found);

#endif
