/* nomogram_chart.h - a nomogram for use with a straight-edge: blank, or with the lines
 * and readings of a room.
 *
 * The sheet may be printed at any size. Alignments remain valid even if width and
 * height are enlarged by different factors.
 */
#ifndef PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CHART_H
#define PP_CHARTS_DRAWING_BOARD_NOMOGRAM_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/nomogram_sheet.h"

/* Height of the scales on the sheet (mm), if the notes leave enough space: 200 mm on
 * upright A4. */
double pp_nomogram_chart_height_mm(const struct pp_canvas *canvas);

/* Least spacing of marks, and of marks with figures, on the sheet (mm). */
double pp_nomogram_chart_fine_mm(const struct pp_canvas *canvas);
double pp_nomogram_chart_number_mm(const struct pp_canvas *canvas);

enum pp_status pp_nomogram_chart_draw(struct pp_canvas *canvas,
                                      const struct pp_nomogram_sheet *sheet,
                                      struct pp_error *err);

#endif
