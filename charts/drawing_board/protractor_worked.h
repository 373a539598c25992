/* protractor_worked.h - a protractor laid on the section and plan of a room: sight
 * lines to edges and jambs of the opening, their readings, and the sum below. */
#ifndef PP_CHARTS_DRAWING_BOARD_PROTRACTOR_WORKED_H
#define PP_CHARTS_DRAWING_BOARD_PROTRACTOR_WORKED_H

#include "charts/sheet/canvas.h"
#include "model/results/protractor_sheet.h"

/* Radius of the protractor on a sheet of this size, in mm. */
double pp_protractor_worked_radius_mm(const struct pp_canvas *canvas);

enum pp_status pp_protractor_worked_draw(struct pp_canvas *canvas,
                                         const struct pp_protractor_sheet *sheet,
                                         struct pp_error *err);

#endif
