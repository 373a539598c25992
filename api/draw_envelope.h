/* draw_envelope.h - the largest envelope on a plot, in plan and as seen from the window
 * that limits it. */
#ifndef PP_API_DRAW_ENVELOPE_H
#define PP_API_DRAW_ENVELOPE_H

#include "charts/sheet/canvas.h"
#include "studies/sizing/plot_envelope.h"

/* Draws the result of pp_plot_envelope_find for the task, whose building must be in the
 * state that the search left. Draws the plan of the site with the plot's heights. If a
 * window limits the heights, and the canvas has further sheets, the Waldram diagram of
 * its vertical sky component follows. file: name as given by the user. */
enum pp_status pp_draw_envelope(struct pp_canvas *canvas,
                                const struct pp_plot_envelope *found,
                                const struct pp_plot_envelope_task *task,
                                const char *file, struct pp_error *err);

#endif
