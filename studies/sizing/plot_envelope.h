/* plot_envelope.h - the largest envelope on a plot that leaves every window about it its due
 * of the sky (retained_sky.h).
 *
 * As codes of building do, a plane for each window rises over the plot from the window's
 * middle, at z_i, away from its wall; the envelope is what lies below all of them, in cells
 * (plot_cells.h), each as high as the planes leave at its nearest corner:
 *
 *     h(cell) = min over i of  z_i + s tan(a_i) max(d_i, 0) - base
 *
 *     d_i  distance of the cell before window i's wall; behind it, the window limits nothing
 *     a_i  altitude at which the plane of window i, were it the only one, would leave that
 *          window just its due
 *     s    1 or more: the greatest common factor at which no window has less than its due
 *
 * so that one of them has just that: the largest of that family. There is no largest of all.
 * A metre more on a tower at the altitude g hides, straight before a window,
 *
 *     (1 + 2 sin g) cos^4 g        of the overcast sky, but for a constant factor
 *
 * which falls above 17 degrees, so that the greatest volume is that of thin towers
 * without end.
 */
#ifndef PP_STUDIES_SIZING_PLOT_ENVELOPE_H
#define PP_STUDIES_SIZING_PLOT_ENVELOPE_H

#include "studies/sizing/plot_cells.h"
#include "studies/sizing/retained_sky.h"

struct pp_plot_envelope_task {
    struct pp_building
        *building;     /* its state, and the block, are changed: the cells take
                                   * its place */
    const char *block; /* block whose footprint is the plot */
    struct pp_retained_sky_rule rule; /* of VSC */
    double most_m;                    /* no cell is higher */
};

enum pp_plot_envelope_verdict {
    PP_PLOT_ENVELOPE_FOUND,
    PP_PLOT_ENVELOPE_ANY, /* even with all cells at most_m every window has its due */
    PP_PLOT_ENVELOPE_NONE /* a window lacks its due with nothing on the plot */
};

struct pp_plot_envelope {
    enum pp_plot_envelope_verdict verdict;
    struct pp_plot_cells cells; /* height_m: 0 where nothing may stand */
    double volume_m3;
    struct pp_retained_sky retained;
    double *altitudes_rad; /* of the planes, atan(s tan a_i); INFINITY where a window
                            * limits nothing, NAN where none was found; owned */
    double factor;         /* s */
    int deciding; /* who has the least over his due; -1: nobody is due anything */
};

/* PP_BAD_INPUT if no window counts, the plot has no cell, or a room is invalid with the
 * objects on it. The caller clears *found in any case. */
enum pp_status pp_plot_envelope_find(struct pp_plot_envelope *found,
                                     const struct pp_plot_envelope_task *task,
                                     struct pp_error *err);
void pp_plot_envelope_clear(struct pp_plot_envelope *found);

#endif
