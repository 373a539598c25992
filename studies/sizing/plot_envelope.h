/* plot_envelope.h - the largest envelope on a plot that leaves every window around it
 * its required share of the sky (retained_sky.h).
 *
 * As in building codes, each window has a plane that rises over the plot from the
 * window's centre, at the height z_i, away from its wall. The envelope is the space
 * below all planes. It is divided into cells (plot_cells.h), each as high as the planes
 * allow at its nearest corner:
 *
 *     h(cell) = min over i of  z_i + s tan(a_i) max(d_i, 0) - base
 *
 *     d_i  distance of the cell before window i's wall; behind the wall the window sets
 *          no limit
 *     a_i  altitude at which window i just keeps its required value if only its own
 *          plane limits the cells
 *     s    1 or more: the greatest common factor with which every window keeps its
 *          required value
 *
 * At least one window then has exactly its required value: this is the largest envelope
 * of this family. There is no largest envelope of any shape. An extra metre on a tower
 * that a window sees straight ahead at the altitude g hides, apart from a constant
 * factor,
 *
 *     (1 + 2 sin g) cos^4 g        of the overcast sky
 *
 * which decreases above 17 degrees. The greatest volume would therefore be thin towers
 * of unlimited height.
 */
#ifndef PP_STUDIES_SIZING_PLOT_ENVELOPE_H
#define PP_STUDIES_SIZING_PLOT_ENVELOPE_H

#include "studies/sizing/plot_cells.h"
#include "studies/sizing/retained_sky.h"

struct pp_plot_envelope_task {
    struct pp_building
        *building;     /* building whose state and block are changed: the cells
                        * replace the block */
    const char *block; /* block whose footprint is the plot */
    struct pp_retained_sky_rule rule; /* rule for VSC */
    double most_m;                    /* greatest height of a cell */
};

enum pp_plot_envelope_verdict {
    PP_PLOT_ENVELOPE_FOUND,
    PP_PLOT_ENVELOPE_ANY, /* all requirements are met even with all cells at most_m */
    PP_PLOT_ENVELOPE_NONE /* some requirement is missed even without a building */
};

struct pp_plot_envelope {
    enum pp_plot_envelope_verdict verdict;
    struct pp_plot_cells cells; /* height_m: 0 if nothing can be built on the cell */
    double volume_m3;
    struct pp_retained_sky retained;
    double *altitudes_rad; /* altitudes of the planes, atan(s tan a_i); INFINITY if a
                            * window sets no limit, NAN if none was found; owned */
    double factor;         /* s */
    int deciding; /* index of the window with the least surplus; -1: none counts */
};

/* PP_BAD_INPUT if no window counts, the plot has no cell, or a room is invalid with the
 * objects on it. The caller clears *found in any case. */
enum pp_status pp_plot_envelope_find(struct pp_plot_envelope *found,
                                     const struct pp_plot_envelope_task *task,
                                     struct pp_error *err);
void pp_plot_envelope_clear(struct pp_plot_envelope *found);

#endif
