/* protractor_chart.h - a daylight protractor to print and cut out: a disc with the
 * primary scale on one half and the auxiliary on the other.
 *
 * The protractor measures angles, so it can be laid on drawings of any scale. Its
 * radius is the largest multiple of 5 mm that fits on the sheet, and is printed.
 */
#ifndef PP_CHARTS_DRAWING_BOARD_PROTRACTOR_CHART_H
#define PP_CHARTS_DRAWING_BOARD_PROTRACTOR_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/protractor_sheet.h"

/* Largest radius that fits on the sheet, and radius of the arc of the primary scale
 * (mm). worked: the arc on a worked sheet, else on a single protractor. */
double pp_protractor_chart_radius_mm(const struct pp_canvas *canvas);
double pp_protractor_chart_arc_mm(const struct pp_canvas *canvas, bool worked);

/* Draws a single protractor, without room or worked example. */
enum pp_status pp_protractor_chart_draw(struct pp_canvas *canvas,
                                        const struct pp_protractor_sheet *sheet,
                                        struct pp_error *err);

#endif
