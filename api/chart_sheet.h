/* chart_sheet.h - a chart with a line that states its origin. */
#ifndef PP_API_CHART_SHEET_H
#define PP_API_CHART_SHEET_H

#include "api/chart_kind.h"

/* Draws a chart by the function of its kind. A line on the sheet states the program
 * version, the room file and, for simulated values, the seed. */
enum pp_status pp_chart_sheet_draw(const struct pp_chart_kind *kind,
                                   struct pp_canvas *canvas, struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice, bool *finished,
                                   struct pp_error *err);

#endif
