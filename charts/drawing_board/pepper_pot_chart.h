/* pepper_pot_chart.h - Pleijel's pepper-pot diagram for a stated viewing distance:
 * blank, or with a room's windows, the counted dots and their sum. */
#ifndef PP_CHARTS_DRAWING_BOARD_PEPPER_POT_CHART_H
#define PP_CHARTS_DRAWING_BOARD_PEPPER_POT_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/board_sheets.h"

/* viewing_mm: distance from the eye to the drawing, 5 to 200. 0: 30, or 60 for dots
 * worth less than 0.05 %; smaller if the windows would not fit on the sheet. */
enum pp_status pp_pepper_pot_chart_draw(struct pp_canvas *canvas,
                                        const struct pp_pepper_pot_sheet *sheet,
                                        double viewing_mm, struct pp_error *err);

#endif
