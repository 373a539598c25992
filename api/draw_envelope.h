/* draw_envelope.h - the largest building envelope on a plot: in plan, and as seen from
 * the window that limits it. */
#ifndef PP_API_DRAW_ENVELOPE_H
#define PP_API_DRAW_ENVELOPE_H

#include "charts/sheet/canvas.h"
#include "studies/sizing/plot_envelope.h"

/* Draws the result of pp_plot_envelope_find for the task. The task's building must be
 * as the search left it. The first sheet is the site plan with the permitted heights on
 * the plot. If a window limits the heights, and the canvas can have further sheets, the
 * Waldram diagram of the window's vertical sky component follows. file: name as given
 * by the user. */
enum pp_status pp_draw_envelope(struct pp_canvas *canvas,
                                const struct pp_plot_envelope *found,
                                const struct pp_plot_envelope_task *task,
                                const char *file, struct pp_error *err);

#endif
