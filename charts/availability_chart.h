/* availability_chart.h - how often the sky gives how much light in working hours, one
 * curve a period, and what that is in a room.
 *
 * Across is the diffuse horizontal illuminance outside, up the share of the working
 * hours that have as much. With a room, a second scale below has the illuminance inside
 * at its daylight factor: of its point where it is drawn for one point, else on
 * average; and each illuminance wanted is a line at what it needs outside, with a dot
 * where it meets each curve. The figures are written below.
 */
#ifndef PP_CHARTS_AVAILABILITY_CHART_H
#define PP_CHARTS_AVAILABILITY_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/sheets/availability_sheet.h"

enum pp_status pp_availability_chart_draw(struct pp_canvas *canvas,
                                          const struct pp_availability_sheet *sheet,
                                          struct pp_error *err);

#endif
