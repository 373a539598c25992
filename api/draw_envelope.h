/* draw_envelope.h - the largest envelope on a plot, in plan and as the window that decides
 * sees it. */
#ifndef PP_API_DRAW_ENVELOPE_H
#define PP_API_DRAW_ENVELOPE_H

#include "charts/sheet/canvas.h"
#include "studies/sizing/plot_envelope.h"

/* Draws what pp_plot_envelope_find has found of the task, whose building stands as that left
 * it: the plan of the site with the plot's heights and, on a further sheet where the canvas
 * has them, the Waldram diagram of the vertical sky component of the window that decides, if
 * one does. file: as the user named it. */
enum pp_status pp_draw_envelope(struct pp_canvas *canvas,
                                const struct pp_plot_envelope *found,
                                const struct pp_plot_envelope_task *task,
                                const char *file, struct pp_error *err);

#endif
