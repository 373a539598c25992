/* chart_sheet.h - a chart on a sheet that says where it comes from. */
#ifndef PP_API_CHART_SHEET_H
#define PP_API_CHART_SHEET_H

#include "api/chart_kind.h"

/* Draws by the kind's own function, on a sheet that says where it comes from: the program's
 * version, the room's file and, where something is simulated, the seed. */
enum pp_status pp_chart_sheet_draw(const struct pp_chart_kind *kind,
                                   struct pp_canvas *canvas, struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice, bool *finished,
                                   struct pp_error *err);

#endif
